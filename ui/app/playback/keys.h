#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/app/cast/carried_pose.h"
#include "ui/app/notices.h"
#include "ui/app/playback/playback.h"
#include "ui/app/playback/pose_clipboard.h"
#include "ui/app/playback/sheet/key_selection.h"
#include "ui/app/session/editing_session.h"

namespace penpose::app {

/// What is done with the keys of the timeline: with those that are selected, else with those at its cursor.
class Keys {
 public:
  Keys(EditingSession& editing, Notices& notices, Playback& playback);

  /// Keys the pose. A name that was given to this key stays.
  void set();
  void remove();
  /// There is something to remove.
  [[nodiscard]] bool any_meant() const { return !selected_.empty() || at_cursor(); }
  [[nodiscard]] bool at_cursor() const;
  /// Names the key, whose pose stays.
  void name(const std::string& name);
  /// The name of a moment's key; empty: it has none, or there is no key.
  [[nodiscard]] std::string name_at(double time_s) const;
  /// Moves all keys of a moment.
  void move(double from_s, double to_s);
  void copy();
  void paste();
  /// Keys the copied pose with left and right exchanged.
  void paste_mirrored();
  /// Exchanges left and right of those that are meant. A control of the other side that has no key there gets one.
  void mirror();
  [[nodiscard]] bool copied() const { return clipboard_.has_value(); }

  /// Keys that the document no longer has are not among them.
  [[nodiscard]] KeySelection& selected();
  /// Moves those that are selected, onto frames: a moment becomes about_s + (moment - about_s) * scale + by_s. They
  /// stay selected. `copies`: they also stay where they are.
  void move_selected(double by_s, double about_s, double scale, bool copies);
  /// Moves them in time, and their values by a share of the range of each control, no farther than it goes.
  void shift_selected(double by_s, double share);
  /// Gives a key another slope, in units a second, on both sides of it or, `alone`, on that side.
  void pull_handle(const KeySelection::Key& key, bool incoming, double slope, bool alone);
  /// How controls go on from them; between two keys, from the one before.
  void set_kind(document::KeyKind kind);
  /// The kinds that those have, each once; empty: there are no keys.
  [[nodiscard]] std::vector<document::KeyKind> kinds() const;
  /// What those are, as people say it: "the key at frame 12"; empty: there is none.
  [[nodiscard]] std::string said() const;
  /// Keys a breakdown at the cursor (document::Tween), of the controls that are selected, else of all.
  void tween(double share);
  /// Shows it, and changes nothing.
  void preview_tween(double share);
  /// Why there can be no breakdown at the cursor, and what to do; empty: there can.
  [[nodiscard]] std::string tween_lacks();

  /// How much of its shine a moment has on which something was keyed just now, 0 to 1.
  [[nodiscard]] double shine(double time_s) const;
  /// A moment shines.
  [[nodiscard]] bool shines() const { return landed_s_ && shine(*landed_s_) > 0; }

 private:
  [[nodiscard]] const document::PoseKey* find(double time_s) const;
  /// The key at the cursor, else the one before; null: there is none.
  [[nodiscard]] const document::PoseKey* going_on() const;
  /// Those that are meant.
  [[nodiscard]] document::OfKeys meant() const;
  [[nodiscard]] document::Tween breakdown(double share);
  /// The selection goes along with its keys.
  void follow(double by_s, double about_s, double scale);
  /// Lets a moment shine.
  void land(double time_s);
  /// The pose is that of the timeline again, after keys changed.
  void show_again();

  EditingSession& editing_;
  Notices& notices_;
  Playback& playback_;
  std::optional<PoseClipboard> clipboard_;
  std::optional<CarriedPose> carried_;  ///< the same for another rig
  KeySelection selected_;
  std::optional<double> landed_s_;  ///< what was keyed last
  std::int64_t landed_us_ = 0;      ///< and when
};

}  // namespace penpose::app
