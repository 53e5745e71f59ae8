#include "core/document/commands/list/view/camera_commands.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "core/document/commands/apply_parts.h"

namespace penpose::document {
namespace {

std::optional<base::Error> beyond(double time_s, const char* member) {
  if (time_s >= 0 && time_s <= k_latest_key_s) return std::nullopt;
  return base::Error{"the moment lies beyond the timeline", member, "give seconds from 0 to 36000"};
}

CameraTrack track_of(const Document& document) { return document.camera ? *document.camera : CameraTrack(); }

Document with_track(const Document& document, CameraTrack track) {
  Document changed = document;
  changed.camera = track.keys.empty() ? nullptr : std::make_shared<const CameraTrack>(std::move(track));
  return changed;
}

/// Puts a key into its place, where it replaces another one.
void put(CameraTrack& track, CameraKey key) {
  const auto place = std::lower_bound(track.keys.begin(), track.keys.end(), key.time_s,
                                      [](const CameraKey& one, double time_s) { return one.time_s < time_s; });
  if (place != track.keys.end() && place->time_s == key.time_s) {
    *place = std::move(key);
  } else {
    track.keys.insert(place, std::move(key));
  }
}

std::optional<CameraKey> take(CameraTrack& track, double time_s) {
  const auto place =
      std::find_if(track.keys.begin(), track.keys.end(), [&](const CameraKey& one) { return one.time_s == time_s; });
  if (place == track.keys.end()) return std::nullopt;
  CameraKey key = std::move(*place);
  track.keys.erase(place);
  return key;
}

base::Error no_camera_key(const char* member) {
  return {"the camera has no key at that moment", member, "name the moment of one"};
}

}  // namespace

Changed run(const Document& document, const KeyCamera& command, Parts&) {
  if (auto error = beyond(command.time_s, "time_s")) return *error;
  if (!is_camera_kind(command.kind))
    return base::Error{"a camera does not go on like that", "kind", "give smooth, linear or stepped"};
  if (const auto camera = geometry::Camera::make(command.view.camera, command.view.viewport); !camera)
    return at("view", camera.error());
  CameraTrack track = track_of(document);
  put(track, {command.time_s, command.view, command.kind});
  if (track.keys.size() > k_most_camera_keys)
    return base::Error{"the camera has 10000 keys already", "time_s", "delete some"};
  return with_track(document, std::move(track));
}

Changed run(const Document& document, const DeleteCameraKeys& command, Parts&) {
  CameraTrack track = track_of(document);
  if (track.keys.empty()) return no_camera_key("times_s");
  if (command.times_s.empty()) return with_track(document, {});
  for (const double time_s : command.times_s) {
    if (!take(track, time_s)) return no_camera_key("times_s");
  }
  return with_track(document, std::move(track));
}

Changed run(const Document& document, const MoveCameraKey& command, Parts&) {
  if (auto error = beyond(command.to_s, "to_s")) return *error;
  CameraTrack track = track_of(document);
  auto key = take(track, command.from_s);
  if (!key) return no_camera_key("from_s");
  key->time_s = command.to_s;
  put(track, std::move(*key));
  return with_track(document, std::move(track));
}

Changed run(const Document& document, const NameView& command, Parts&) {
  if (command.to.empty()) return base::Error{"a view needs a name", "to", "give one"};
  Document changed = document;
  std::shared_ptr<const NamedView>* found = nullptr;
  for (auto& named : changed.views) {
    if (named->name == command.name) found = &named;
    if (named->name == command.to && command.to != command.name)
      return base::Error{"another view has that name", "to", "give one of its own"};
  }
  if (found == nullptr) return base::Error{"there is no view of that name", "name", ""};
  NamedView renamed = **found;
  renamed.name = command.to;
  *found = std::make_shared<const NamedView>(std::move(renamed));
  return changed;
}

}  // namespace penpose::document
