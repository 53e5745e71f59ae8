#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "ui/app/files/player.h"
#include "ui/app/notices.h"
#include "ui/app/playback/performance.h"
#include "ui/app/playback/playback.h"
#include "ui/app/session/editing_session.h"

namespace penpose::app {

/// A take that was just keyed.
struct Take {
  double from_s = 0;
  double to_s = 0;
  std::size_t frames = 0;
  std::size_t keys = 0;                                ///< moments with keys
  std::shared_ptr<const document::Timeline> timeline;  ///< as the take left it
  std::size_t steps = 0;                               ///< that were done before it
};

/// The pen as a puppet's string: time runs while it holds a target or a place of the model, and what the face does is
/// keyed.
class Performer {
 public:
  Performer(EditingSession& editing, Notices& notices, Playback& playback, const Player& player);

  /// What the pen does is being keyed frame by frame.
  [[nodiscard]] bool performing() const { return performance_.has_value(); }
  /// Frames that were recorded so far. Precondition: performing().
  [[nodiscard]] std::size_t frame_count() const { return performance_->frame_count(); }
  /// The pen is about to pull: what plays stops, and the pose is that of the playhead.
  void ready();

  /// The take that was keyed last, while nothing else is done to the face; null: none.
  [[nodiscard]] const Take* take() const;
  /// Takes it back and goes to its start, to be performed anew.
  void again();
  /// It stays; the playhead goes back to its start.
  void keep();
  /// Plays it from its start.
  void review();

  /// Begins, goes on or ends; at a moment of the clock, microseconds.
  void follow(std::int64_t now_us);
  /// Keys what was performed; false where that was nothing. Precondition: performing().
  bool end();
  /// Forgets what was performed.
  void drop() {
    performance_.reset();
    take_.reset();
  }

 private:
  void begin(std::int64_t now_us);
  /// The length of the line under the pen, px.
  [[nodiscard]] double drawn_px() const;

  EditingSession& editing_;
  Notices& notices_;
  Playback& playback_;
  const Player& player_;
  std::optional<Performance> performance_;
  std::optional<Take> take_;
  std::size_t steps_ = 0;  ///< that were done when it began
  double from_s_ = 0;
  std::int64_t from_us_ = 0;
};

}  // namespace penpose::app
