#include "core/document/commands/list/time_commands.h"

#include <algorithm>
#include <string>

#include "core/document/commands/apply_parts.h"

namespace penpose::document {
namespace {

std::optional<base::Error> check_time(double time_s, const char* member) {
  if (time_s >= 0 && time_s <= k_latest_key_s) return std::nullopt;
  return base::Error{"the moment is not on the timeline", member, "give seconds from 0 to 36000"};
}

auto key_at(Timeline& timeline, double time_s) {
  return std::lower_bound(timeline.keys.begin(), timeline.keys.end(), time_s,
                          [](const PoseKey& key, double time) { return key.time_s < time; });
}

bool is_at(const Timeline& timeline, std::vector<PoseKey>::const_iterator key, double time_s) {
  return key != timeline.keys.end() && key->time_s == time_s;
}

base::Error no_key(const char* member) {
  return {"there is no key at that moment", member, "name the moment of a key"};
}

Document with_timeline(const Document& document, Timeline timeline) {
  Document changed = document;
  changed.timeline = std::make_shared<const Timeline>(std::move(timeline));
  return changed;
}

/// The numbers of the controls that were performed.
base::Result<std::vector<std::size_t>> check_performed(const Document& document, const KeyPoses& command) {
  const auto parameters = document.model->rig->parameters();
  const std::size_t count = command.names.size();
  if (count == 0 || command.times_s.empty())
    return base::Error{"nothing was performed", "names", "name controls and moments"};
  if (command.values.size() != count * command.times_s.size())
    return base::Error{"there is not one value for each control and moment", "values", "give one row a moment"};
  std::vector<std::size_t> numbers;
  for (const std::string& name : command.names) {
    const auto number = rig::find_parameter(parameters, name);
    if (!number)
      return base::Error{"the model has no parameter \"" + name + "\"", "names", "look at the names in the model"};
    if (std::find(numbers.begin(), numbers.end(), *number) != numbers.end())
      return base::Error{"\"" + name + "\" is named twice", "names", "name it once"};
    numbers.push_back(*number);
  }
  for (std::size_t i = 0; i < command.times_s.size(); ++i) {
    if (auto error = check_time(command.times_s[i], "times_s")) return *error;
    if (i > 0 && command.times_s[i] <= command.times_s[i - 1])
      return base::Error{"the moments do not ascend", "times_s", "give each once, the earliest first"};
    for (std::size_t k = 0; k < count; ++k) {
      if (auto error = out_of_range(parameters[numbers[k]], command.values[i * count + k])) return *error;
    }
  }
  return numbers;
}

}  // namespace

Changed run(const Document& document, const SetKey& command, Parts&) {
  if (auto error = check_time(command.time_s, "time_s")) return *error;
  Timeline timeline = *document.timeline;
  const auto place = key_at(timeline, command.time_s);
  if (is_at(timeline, place, command.time_s)) {
    *place = {command.time_s, document.pose, command.name};
  } else {
    timeline.keys.insert(place, {command.time_s, document.pose, command.name});
  }
  Document changed = with_timeline(document, std::move(timeline));
  changed.time_s = command.time_s;
  return changed;
}

Changed run(const Document& document, const KeyPoses& command, Parts&) {
  const auto numbers = check_performed(document, command);
  if (!numbers) return numbers.error();
  const std::vector<double>& times = command.times_s;
  const Timeline& before = *document.timeline;
  // A pose with what was performed at a moment: at moment i, or evenly between the one before it and it.
  const auto with_performed = [&](rig::Pose pose, double time_s, std::size_t i) {
    const double* to = command.values.data() + i * numbers->size();
    for (std::size_t k = 0; k < numbers->size(); ++k) {
      pose[(*numbers)[k]] = to[k];
      if (time_s == times[i]) continue;
      const double from = to[static_cast<std::ptrdiff_t>(k) - static_cast<std::ptrdiff_t>(numbers->size())];
      const double between = from + (to[k] - from) * ((time_s - times[i - 1]) / (times[i] - times[i - 1]));
      pose[(*numbers)[k]] = std::clamp(between, std::min(from, to[k]), std::max(from, to[k]));
    }
    return pose;
  };
  Timeline timeline{before.interpolation, {}};
  timeline.keys.reserve(before.keys.size() + times.size());
  auto key = before.keys.begin();
  const auto comes_before = [&](double time_s) { return key != before.keys.end() && key->time_s < time_s; };
  for (; comes_before(times.front()); ++key) timeline.keys.push_back(*key);
  for (std::size_t i = 0; i < times.size(); ++i) {
    for (; comes_before(times[i]); ++key)
      timeline.keys.push_back({key->time_s, with_performed(key->pose, key->time_s, i), key->name});
    PoseKey one{times[i], before.keys.empty() ? document.pose : sample(before, times[i]), {}};
    one.pose = with_performed(one.pose, times[i], i);
    if (is_at(before, key, times[i])) one.name = (key++)->name;
    timeline.keys.push_back(std::move(one));
  }
  timeline.keys.insert(timeline.keys.end(), key, before.keys.end());
  return with_timeline(document, std::move(timeline));
}

Changed run(const Document& document, const DeleteKey& command, Parts&) {
  Timeline timeline = *document.timeline;
  const auto place = key_at(timeline, command.time_s);
  if (!is_at(timeline, place, command.time_s)) return no_key("time_s");
  timeline.keys.erase(place);
  return with_timeline(document, std::move(timeline));
}

Changed run(const Document& document, const MoveKey& command, Parts&) {
  if (auto error = check_time(command.to_s, "to_s")) return *error;
  Timeline timeline = *document.timeline;
  const auto from = key_at(timeline, command.from_s);
  if (!is_at(timeline, from, command.from_s)) return no_key("from_s");
  PoseKey key = *from;
  key.time_s = command.to_s;
  timeline.keys.erase(from);
  const auto to = key_at(timeline, command.to_s);
  if (is_at(timeline, to, command.to_s)) {
    return base::Error{"another key is at that moment", "to_s", "delete it first"};
  }
  timeline.keys.insert(to, std::move(key));
  return with_timeline(document, std::move(timeline));
}

Changed run(const Document& document, const SetKeyInterpolation& command, Parts&) {
  Timeline timeline = *document.timeline;
  timeline.interpolation = command.interpolation;
  return with_timeline(document, std::move(timeline));
}

Changed run(const Document& document, const GoToTime& command, Parts&) {
  if (auto error = check_time(command.time_s, "time_s")) return *error;
  Document changed = document;
  changed.time_s = command.time_s;
  if (!document.timeline->keys.empty()) changed.pose = sample(*document.timeline, command.time_s);
  return changed;
}

Changed run(const Document& document, const SaveView& command, Parts&) {
  if (command.name.empty()) return base::Error{"a view needs a name", "name", "give one"};
  if (const auto camera = geometry::Camera::make(command.view.camera, command.view.viewport); !camera) {
    return at("view", camera.error());
  }
  Document changed = document;
  auto saved = std::make_shared<const NamedView>(NamedView{command.name, command.view});
  for (auto& named : changed.views) {
    if (named->name != command.name) continue;
    named = std::move(saved);
    return changed;
  }
  changed.views.push_back(std::move(saved));
  return changed;
}

Changed run(const Document& document, const DeleteView& command, Parts&) {
  Document changed = document;
  const auto named = std::find_if(changed.views.begin(), changed.views.end(),
                                  [&](const auto& one) { return one->name == command.name; });
  if (named == changed.views.end()) return base::Error{"there is no view of that name", "name", ""};
  changed.views.erase(named);
  return changed;
}

}  // namespace penpose::document
