#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/document/commands/command_members.h"
#include "core/document/commands/command_parts.h"
#include "core/document/drawing/pose_curve.h"
#include "core/document/time/timeline.h"

// Commands of keys and views.

namespace penpose::document {

/// Keys the pose at a moment, in place of a key that is there. The pose may have a name.
struct SetKey {
  static constexpr Called k_called{"set_key", "Key the pose"};
  double time_s = 0;
  std::string name;
  static auto members(auto& self) { return base::named("time_s", self.time_s, "name", self.name); }
};
Changed run(const Document&, const SetKey&, ApplyParts&);

/// Keys a performance: some controls at some moments. At each moment the other controls take the timeline's values, or
/// the pose's where nothing is keyed. Keys between two moments stay; there these controls are interpolated linearly.
/// Errors: no such parameter or one named twice, a value out of range, moments that do not ascend, another number of
/// values.
struct KeyPoses {
  static constexpr Called k_called{"key_poses", "Perform"};
  std::vector<std::string> names;
  std::vector<double> times_s;
  std::vector<double> values;  ///< a row for each moment, a value for each name
  static auto members(auto& self) {
    return base::named("names", self.names, "times_s", self.times_s, "values", self.values);
  }
};
Changed run(const Document&, const KeyPoses&, ApplyParts&);

struct DeleteKey : AtTime {
  static constexpr Called k_called{"delete_key", "Delete a key"};
};
Changed run(const Document&, const DeleteKey&, ApplyParts&);

/// Errors: no key there, another key where it should go.
struct MoveKey {
  static constexpr Called k_called{"move_key", "Move a key"};
  double from_s = 0;
  double to_s = 0;
  static auto members(auto& self) { return base::named("from_s", self.from_s, "to_s", self.to_s); }
};
Changed run(const Document&, const MoveKey&, ApplyParts&);

struct SetKeyInterpolation {
  static constexpr Called k_called{"set_key_interpolation", "Change interpolation"};
  KeyInterpolation interpolation = KeyInterpolation::smooth;
  static auto members(auto& self) { return base::named("interpolation", self.interpolation); }
};
Changed run(const Document&, const SetKeyInterpolation&, ApplyParts&);

/// Takes the pose of the timeline at a moment.
struct GoToTime : AtTime {
  static constexpr Called k_called{"go_to_time", "Go to a moment"};
};
Changed run(const Document&, const GoToTime&, ApplyParts&);

/// Keeps a view under a name, in place of one of that name.
struct SaveView {
  static constexpr Called k_called{"save_view", "Keep a view"};
  std::string name;
  View view;
  static auto members(auto& self) { return base::named("name", self.name, "view", self.view); }
};
Changed run(const Document&, const SaveView&, ApplyParts&);

struct DeleteView : OfName {
  static constexpr Called k_called{"delete_view", "Delete a view"};
};
Changed run(const Document&, const DeleteView&, ApplyParts&);

using TimeCommands =
    std::variant<SetKey, KeyPoses, DeleteKey, MoveKey, SetKeyInterpolation, GoToTime, SaveView, DeleteView>;

}  // namespace penpose::document
