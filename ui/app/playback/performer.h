#pragma once

#include <optional>

#include "ui/app/files/player.h"
#include "ui/app/notices.h"
#include "ui/app/playback/performance.h"
#include "ui/app/playback/playback.h"
#include "ui/app/session/editing_session.h"

namespace penpose::app {

/// The pen as a puppet's string: time runs while it holds a target, and what the face does is keyed.
class Performer {
 public:
  Performer(EditingSession& editing, Notices& notices, Playback& playback, const Player& player);

  /// What the pen does is being keyed frame by frame.
  [[nodiscard]] bool performing() const { return performance_.has_value(); }
  /// Begins, goes on or ends; at a moment of the clock, microseconds.
  void follow(std::int64_t now_us);
  /// Keys what was performed; false where that was nothing. Precondition: performing().
  bool end();
  /// Forgets what was performed.
  void drop() { performance_.reset(); }

 private:
  void begin(std::int64_t now_us);
  /// The length of the line under the pen, px.
  [[nodiscard]] double drawn_px() const;

  EditingSession& editing_;
  Notices& notices_;
  Playback& playback_;
  const Player& player_;
  std::optional<Performance> performance_;
  std::size_t steps_ = 0;  ///< that were done when it began
  double from_s_ = 0;
  std::int64_t from_us_ = 0;
};

}  // namespace penpose::app
