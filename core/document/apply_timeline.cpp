#include <algorithm>
#include <string>

#include "core/document/apply_parts.h"

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
