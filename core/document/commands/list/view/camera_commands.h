#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/document/commands/command_members.h"
#include "core/document/commands/command_parts.h"
#include "core/document/view/camera_track.h"

// Commands of the camera that moves along the timeline, and of the names of kept views.

namespace penpose::document {

/// Keys the camera at a moment, in place of a key that is there. Errors: a moment beyond the timeline, no view, a kind
/// that cameras do not have, too many keys.
struct KeyCamera {
  static constexpr Called k_called{"key_camera", "Key the camera"};
  double time_s = 0;
  View view;  ///< of what is filmed; its viewport tells the shape of the picture
  KeyKind kind = KeyKind::smooth;
  static auto members(auto& self) { return base::named("time_s", self.time_s, "view", self.view, "kind", self.kind); }
};
Changed run(const Document&, const KeyCamera&, ApplyParts&);

/// Removes keys of the camera; all of them where no moments are given. Errors: no such key.
struct DeleteCameraKeys {
  static constexpr Called k_called{"delete_camera_keys", "Delete camera keys"};
  std::vector<double> times_s;
  static auto members(auto& self) { return base::named("times_s", self.times_s); }
};
Changed run(const Document&, const DeleteCameraKeys&, ApplyParts&);

/// Moves a key of the camera to another moment, where it replaces one. Errors: no such key, a moment beyond the
/// timeline.
struct MoveCameraKey {
  static constexpr Called k_called{"move_camera_key", "Move a camera key"};
  double from_s = 0;
  double to_s = 0;
  static auto members(auto& self) { return base::named("from_s", self.from_s, "to_s", self.to_s); }
};
Changed run(const Document&, const MoveCameraKey&, ApplyParts&);

/// Gives a kept view another name. Errors: no such view, no name or one that another view has.
struct NameView {
  static constexpr Called k_called{"name_view", "Name a camera"};
  std::string name;
  std::string to;
  static auto members(auto& self) { return base::named("name", self.name, "to", self.to); }
};
Changed run(const Document&, const NameView&, ApplyParts&);

using CameraCommands = std::variant<KeyCamera, DeleteCameraKeys, MoveCameraKey, NameView>;

}  // namespace penpose::document
