#pragma once

#include <optional>
#include <string>

#include "ui/app/notices.h"
#include "ui/app/playback/playback.h"
#include "ui/app/playback/pose_clipboard.h"
#include "ui/app/session/editing_session.h"

namespace penpose::app {

/// What is done with the keys of the timeline, at its cursor.
class Keys {
 public:
  Keys(EditingSession& editing, Notices& notices, Playback& playback);

  /// Keys the pose. A name that was given to this key stays.
  void set();
  void remove();
  [[nodiscard]] bool at_cursor() const;
  /// Names the key, whose pose stays.
  void name(const std::string& name);
  /// The name of a moment's key; empty: it has none, or there is no key.
  [[nodiscard]] std::string name_at(double time_s) const;
  /// Moves a key; one that is in the way is told.
  void move(double from_s, double to_s);
  void copy();
  void paste();
  [[nodiscard]] bool copied() const { return clipboard_.has_value(); }

 private:
  [[nodiscard]] const document::PoseKey* find(double time_s) const;

  EditingSession& editing_;
  Notices& notices_;
  Playback& playback_;
  std::optional<PoseClipboard> clipboard_;
};

}  // namespace penpose::app
