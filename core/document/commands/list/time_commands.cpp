#include "core/document/commands/list/time_commands.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "core/document/commands/apply_parts.h"
#include "core/document/sound/moved_mouths.h"
#include "core/document/time/timeline_editing.h"

namespace penpose::document {
namespace {

constexpr double k_steepest = 1e9;

std::optional<base::Error> check_time(double time_s, const char* member) {
  if (time_s >= 0 && time_s <= k_latest_key_s) return std::nullopt;
  return base::Error{"the moment is not on the timeline", member, "give seconds from 0 to 36000"};
}

Document with_timeline(const Document& document, Timeline timeline) {
  Document changed = document;
  changed.timeline = std::make_shared<const Timeline>(std::move(timeline));
  return changed;
}

TimelineEditing edit(const Document& document) {
  return {*document.timeline, document.model->rig->parameters(), document.pose};
}

/// A key of one control: its place in the list, and its number.
struct KeyPlace {
  std::size_t place = 0;
  std::size_t parameter = 0;
};

base::Result<std::vector<KeyPlace>> places_of(const Document& document, const OfKeys& keys) {
  const Timeline& timeline = *document.timeline;
  if (keys.times_s.empty()) return base::Error{"no key is meant", "times_s", "name the moments of keys"};
  if (!keys.names.empty() && keys.names.size() != keys.times_s.size())
    return base::Error{"there is not one name for each moment", "names", "name a control for each, or none at all"};
  const auto numbers = numbers_of(document, keys.names);
  if (!numbers) return numbers.error();
  std::vector<KeyPlace> places;
  for (std::size_t i = 0; i < keys.times_s.size(); ++i) {
    const auto place = key_at(timeline, keys.times_s[i]);
    if (!place || (!numbers->empty() && !timeline.keys[*place].controls.has((*numbers)[i])))
      return base::Error{"there is no key at that moment", "times_s", "name the moment of a key"};
    if (!numbers->empty()) {
      places.push_back({*place, (*numbers)[i]});
      continue;
    }
    for (std::size_t p = 0; p < document.pose.size(); ++p) {
      if (timeline.keys[*place].controls.has(p)) places.push_back({*place, p});
    }
  }
  return places;
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
    const auto number = number_of(document, name, "names");
    if (!number) return number.error();
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
  const auto numbers = numbers_of(document, command.names);
  if (!numbers) return numbers.error();
  // The kind of a key that is there stays.
  const auto place = key_at(*document.timeline, command.time_s);
  TimelineEditing keys = edit(document);
  const auto set = [&](std::size_t p) {
    const bool known = place && document.timeline->keys[*place].controls.has(p);
    keys.set(command.time_s, p, document.pose[p], known ? document.timeline->keys[*place].controls[p] : ControlKey{});
  };
  for (const std::size_t p : *numbers) set(p);
  for (std::size_t p = 0; numbers->empty() && p < document.pose.size(); ++p) set(p);
  keys.name(command.time_s, command.name);
  Document changed = with_timeline(document, std::move(keys).finish());
  changed.time_s = command.time_s;
  return changed;
}

Changed run(const Document& document, const KeyPoses& command, Parts&) {
  const auto numbers = check_performed(document, command);
  if (!numbers) return numbers.error();
  TimelineEditing keys = edit(document);
  for (const PoseKey& key : document.timeline->keys) {
    if (key.time_s < command.times_s.front() || key.time_s > command.times_s.back()) continue;
    for (const std::size_t p : *numbers) keys.erase(key.time_s, p);
  }
  for (std::size_t i = 0; i < command.times_s.size(); ++i) {
    for (std::size_t k = 0; k < numbers->size(); ++k)
      keys.set(command.times_s[i], (*numbers)[k], command.values[i * numbers->size() + k], {});
  }
  return with_timeline(document, std::move(keys).finish());
}

Changed run(const Document& document, const DeleteKeys& command, Parts&) {
  const auto places = places_of(document, command);
  if (!places) return places.error();
  TimelineEditing keys = edit(document);
  for (const KeyPlace& one : *places) keys.erase(document.timeline->keys[one.place].time_s, one.parameter);
  return with_timeline(document, std::move(keys).finish());
}

Changed run(const Document& document, const MoveKeys& command, Parts&) {
  const auto places = places_of(document, command);
  if (!places) return places.error();
  if (!(command.scale > 0)) return base::Error{"keys cannot be scaled so", "scale", "give a number above 0"};
  const Timeline& before = *document.timeline;
  const auto moved = [&](double time_s) {
    const double to_s = command.about_s + (time_s - command.about_s) * command.scale + command.by_s;
    return command.rate > 0 ? std::round(to_s * command.rate) / command.rate : to_s;
  };
  for (const KeyPlace& one : *places) {
    if (auto error = check_time(moved(before.keys[one.place].time_s), "by_s")) return *error;
  }
  TimelineEditing keys = edit(document);
  std::map<std::size_t, std::vector<std::size_t>> taken;  // by moments
  for (const KeyPlace& one : *places) {
    taken[one.place].push_back(one.parameter);
    if (!command.copies) keys.erase(before.keys[one.place].time_s, one.parameter);
  }
  for (const KeyPlace& one : *places) {
    const PoseKey& key = before.keys[one.place];
    ControlKey control = key.controls[one.parameter];
    control.in /= command.scale;
    control.out /= command.scale;
    keys.set(moved(key.time_s), one.parameter, key.pose[one.parameter], control);
  }
  std::vector<KeysMoved> went;
  for (const auto& [place, controls] : taken) {
    const PoseKey& key = before.keys[place];
    std::size_t all = 0;
    for (std::size_t p = 0; p < document.pose.size(); ++p) all += key.controls.has(p) ? 1 : 0;
    if (controls.size() == all && !key.name.empty()) keys.name(moved(key.time_s), key.name);
    went.push_back({place, controls, moved(key.time_s)});
  }
  Document changed = with_timeline(document, std::move(keys).finish());
  changed.spoken = with_moved_keys(document, went, command.copies);
  return changed;
}

Changed run(const Document& document, const SetKeyKind& command, Parts&) {
  const auto places = places_of(document, command);
  if (!places) return places.error();
  if (command.kind == KeyKind::none) return base::Error{"a key has a kind", "kind", "delete the key instead"};
  TimelineEditing keys = edit(document);
  for (const KeyPlace& one : *places) {
    const PoseKey& key = document.timeline->keys[one.place];
    ControlKey control{command.kind, 0, 0};
    if (has_slopes(command.kind)) {
      control = with_slopes(*document.timeline, one.place, one.parameter);
      control.kind = command.kind;
    }
    keys.set(key.time_s, one.parameter, key.pose[one.parameter], control);
  }
  return with_timeline(document, std::move(keys).finish());
}

Changed run(const Document& document, const SetKeyValues& command, Parts&) {
  if (command.names.empty()) return base::Error{"no control is named", "names", "name one for each moment"};
  const auto places = places_of(document, command);
  if (!places) return places.error();
  if (command.values.size() != places->size())
    return base::Error{"there is not one value for each key", "values", "give one a key"};
  TimelineEditing keys = edit(document);
  for (std::size_t i = 0; i < places->size(); ++i) {
    const KeyPlace& one = (*places)[i];
    if (auto error = out_of_range(document.model->rig->parameters()[one.parameter], command.values[i])) return *error;
    const PoseKey& key = document.timeline->keys[one.place];
    keys.set(key.time_s, one.parameter, command.values[i], key.controls[one.parameter]);
  }
  return with_timeline(document, std::move(keys).finish());
}

Changed run(const Document& document, const SetKeySlopes& command, Parts&) {
  const auto places = places_of(document, OfKeys{{command.time_s}, {command.name}});
  if (!places) return places.error();
  if (!(std::abs(command.in) <= k_steepest && std::abs(command.out) <= k_steepest))
    return base::Error{"the slope is no number", "in", "give units a second, at most 1e9"};
  TimelineEditing keys = edit(document);
  const PoseKey& key = document.timeline->keys[places->front().place];
  const std::size_t p = places->front().parameter;
  const KeyKind kind = key.controls[p].kind == KeyKind::overshoot ? KeyKind::overshoot : KeyKind::free;
  keys.set(key.time_s, p, key.pose[p], {kind, command.in, command.out});
  return with_timeline(document, std::move(keys).finish());
}

Changed run(const Document& document, const Tween& command, Parts&) {
  if (auto error = check_time(command.time_s, "time_s")) return *error;
  if (!std::isfinite(command.share)) return base::Error{"the share is no number", "share", "give one, 0.5 is half way"};
  const auto numbers = numbers_of(document, command.names);
  if (!numbers) return numbers.error();
  const Timeline& timeline = *document.timeline;
  const std::size_t place = first_from(timeline, command.time_s);
  const auto at_key = key_at(timeline, command.time_s);
  TimelineEditing keys = edit(document);
  bool any = false;
  for (std::size_t p = 0; p < document.pose.size(); ++p) {
    if (!numbers->empty() && std::find(numbers->begin(), numbers->end(), p) == numbers->end()) continue;
    const auto before = place > 0 ? key_before(timeline, p, place - 1) : std::nullopt;
    const auto after = key_after(timeline, p, at_key ? place + 1 : place);
    if (!before || !after) continue;
    any = true;
    const double from = timeline.keys[*before].pose[p];
    const double value = from + (timeline.keys[*after].pose[p] - from) * command.share;
    const rig::Parameter& range = document.model->rig->parameters()[p];
    const bool keyed = at_key && timeline.keys[place].controls.has(p);
    keys.set(command.time_s, p, std::clamp(value, range.minimum, range.maximum),
             keyed ? timeline.keys[place].controls[p] : ControlKey{});
  }
  if (!any)
    return base::Error{"no control has a key before that moment and one after it", "time_s",
                       "choose a moment between two keys"};
  if (at_key) keys.name(command.time_s, timeline.keys[place].name);
  Document changed = with_timeline(document, std::move(keys).finish());
  changed.time_s = command.time_s;
  changed.pose = pose_at(changed, command.time_s);
  return changed;
}

Changed run(const Document& document, const GoToTime& command, Parts&) {
  if (auto error = check_time(command.time_s, "time_s")) return *error;
  Document changed = document;
  changed.time_s = command.time_s;
  changed.pose = pose_at(document, command.time_s);
  return changed;
}

Changed run(const Document& document, const SaveView& command, Parts&) {
  if (command.name.empty()) return base::Error{"a view needs a name", "name", "give one"};
  if (const auto camera = geometry::Camera::make(command.view.camera, command.view.viewport); !camera) {
    return at("view", camera.error());
  }
  if (command.key > k_view_keys) return base::Error{"there is no such key", "key", "give 1 to 9, or 0 for none"};
  Document changed = document;
  NamedView saved{command.name, command.view, command.key};
  std::shared_ptr<const NamedView>* before = nullptr;
  for (auto& named : changed.views) {
    if (named->name == command.name) {
      before = &named;
    } else if (command.key != 0 && named->key == command.key) {
      named = std::make_shared<const NamedView>(NamedView{named->name, named->view});
    }
  }
  if (before == nullptr) {
    changed.views.push_back(std::make_shared<const NamedView>(std::move(saved)));
    return changed;
  }
  if (saved.key == 0) saved.key = (*before)->key;
  *before = std::make_shared<const NamedView>(std::move(saved));
  return changed;
}

Changed run(const Document& document, const DeleteView& command, Parts&) {
  Document changed = document;
  if (!erase_named(changed.views, command.name)) return base::Error{"there is no view of that name", "name", ""};
  return changed;
}

}  // namespace penpose::document
