#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "core/document/commands/command_members.h"
#include "core/document/commands/command_parts.h"
#include "core/document/drawing/pose_curve.h"
#include "core/document/time/timeline.h"

// Commands of keys and views.

namespace penpose::document {

/// Keys the pose at a moment, in place of keys that are there. The moment may have a name. Errors: no such control.
struct SetKey {
  static constexpr Called k_called{"set_key", "Key the pose"};
  double time_s = 0;
  std::string name;
  std::vector<std::string> names = {};  ///< of the controls that are keyed; empty: all of them
  static auto members(auto& self) { return base::named("time_s", self.time_s, "name", self.name, "names", self.names); }
};
Changed run(const Document&, const SetKey&, ApplyParts&);

/// Keys a performance: some controls at some moments, in place of what keys they have from the first of these moments
/// to the last. Errors: no such parameter or one named twice, a value out of range, moments that do not ascend, another
/// number of values.
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

/// Keys that a command is about: a control's at a moment, one pair after the other. Without names: all keys at these
/// moments. Errors: another number of names than of moments, no such control, no key there.
struct OfKeys {
  std::vector<double> times_s;
  std::vector<std::string> names;
};

struct DeleteKeys : OfKeys {
  static constexpr Called k_called{"delete_keys", "Delete keys"};
  static auto members(auto& self) { return base::named("times_s", self.times_s, "names", self.names); }
};
Changed run(const Document&, const DeleteKeys&, ApplyParts&);

/// Moves keys in time: a moment becomes about_s + (moment - about_s) * scale + by_s. Keys of these controls where they
/// arrive are replaced. Names of moments whose keys are all moved go along, and so do spoken mouths (with_moved_keys).
/// Errors: a moment off the timeline, a scale that is not above 0.
struct MoveKeys : OfKeys {
  static constexpr Called k_called{"move_keys", "Move keys"};
  double by_s = 0;
  double about_s = 0;
  double scale = 1;
  bool copies = false;     ///< the keys also stay where they are
  std::uint32_t rate = 0;  ///< moments are rounded to frames of this rate; 0: they are not
  static auto members(auto& self) {
    return base::named("times_s", self.times_s, "names", self.names, "by_s", self.by_s, "about_s", self.about_s,
                       "scale", self.scale, "copies", self.copies, "rate", self.rate);
  }
};
Changed run(const Document&, const MoveKeys&, ApplyParts&);

/// How controls go on from keys. A key that becomes free or overshooting keeps the slopes that it has. Errors:
/// KeyKind::none.
struct SetKeyKind : OfKeys {
  static constexpr Called k_called{"set_key_kind", "Change interpolation"};
  KeyKind kind = KeyKind::smooth;
  static auto members(auto& self) {
    return base::named("times_s", self.times_s, "names", self.names, "kind", self.kind);
  }
};
Changed run(const Document&, const SetKeyKind&, ApplyParts&);

/// Gives keys other values, one each. Errors: a value out of range, another number of values.
struct SetKeyValues : OfKeys {
  static constexpr Called k_called{"set_key_values", "Change keys"};
  std::vector<double> values;
  static auto members(auto& self) {
    return base::named("times_s", self.times_s, "names", self.names, "values", self.values);
  }
};
Changed run(const Document&, const SetKeyValues&, ApplyParts&);

/// The slopes of a control at its key, which becomes free: of what leads there and of what leaves, in units a second.
/// They are no steeper than the control's range allows. Errors: no key there, slopes that are not numbers.
struct SetKeySlopes {
  static constexpr Called k_called{"set_key_slopes", "Pull a handle"};
  double time_s = 0;
  std::string name;
  double in = 0;
  double out = 0;
  static auto members(auto& self) {
    return base::named("time_s", self.time_s, "name", self.name, "in", self.in, "out", self.out);
  }
};
Changed run(const Document&, const SetKeySlopes&, ApplyParts&);

/// A breakdown: keys controls at a moment, at a share of the way from their key before it to their key after it. Below
/// 0 and above 1 they overshoot, within their ranges. Errors: no such control, none that has keys on both sides.
struct Tween {
  static constexpr Called k_called{"tween", "Breakdown"};
  double time_s = 0;
  double share = 0.5;
  std::vector<std::string> names;  ///< empty: all that have keys on both sides
  static auto members(auto& self) {
    return base::named("time_s", self.time_s, "share", self.share, "names", self.names);
  }
};
Changed run(const Document&, const Tween&, ApplyParts&);

/// Takes the pose of the timeline at a moment.
using GoToTime = Plain<AtTime, "go_to_time", "Go to a moment">;
Changed run(const Document&, const GoToTime&, ApplyParts&);

/// Keeps a view under a name, in place of one of that name. Errors: no name, no view, no such key.
struct SaveView {
  static constexpr Called k_called{"save_view", "Keep a view"};
  std::string name;
  View view;
  std::uint32_t key = 0;  ///< 1..9: is taken from the view that has it; 0: the view keeps the key that it has
  static auto members(auto& self) { return base::named("name", self.name, "view", self.view, "key", self.key); }
};
Changed run(const Document&, const SaveView&, ApplyParts&);

using DeleteView = Plain<OfName, "delete_view", "Delete a view">;
Changed run(const Document&, const DeleteView&, ApplyParts&);

using TimeCommands = std::variant<SetKey, KeyPoses, DeleteKeys, MoveKeys, SetKeyKind, SetKeyValues, SetKeySlopes, Tween,
                                  GoToTime, SaveView, DeleteView>;

}  // namespace penpose::document
