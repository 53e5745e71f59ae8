#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string_view>

#include "ui/app/notices.h"
#include "ui/app/playback/loop_range.h"
#include "ui/app/preferences.h"
#include "ui/app/session/editing_session.h"

namespace penpose::app {

/// This notice tells the user that no key has the pose yet. Keying the pose removes it.
inline constexpr std::string_view k_not_keyed_yet =
    "the pose is not on the timeline yet: Key puts it here; going to another key leaves it";

/// What is done besides while one draws.
struct WhileDrawing {
  bool mirrors = false;   ///< strokes work on both sides
  bool auto_key = false;  ///< every change of the pose is keyed
  bool performs = false;  ///< time runs while the pen holds a target, and what the face does is keyed
};

/// How fast the timeline can be played, as shares of its own pace.
inline constexpr std::array k_speeds{1.0, 0.5, 0.25};

/// The timeline's cursor: scrubbed, stepped and played. Moments are seconds.
class Playback {
 public:
  using Clock = std::function<std::int64_t()>;
  Playback(Clock clock, EditingSession& editing, Notices& notices, Preferences& preferences);

  [[nodiscard]] double time_s() const { return time_s_; }
  /// Moves the cursor alone, and not the pose.
  void place_cursor(double time_s) { time_s_ = time_s; }
  [[nodiscard]] int rate() const { return rate_; }
  /// Frames a second, which other documents take over.
  void set_rate(int rate);
  /// How fast it is played, one of k_speeds.
  [[nodiscard]] double speed() const { return speed_; }
  void set_speed(double speed);
  /// Microseconds of a clock that never goes back.
  [[nodiscard]] std::int64_t now_us() const { return clock_(); }
  [[nodiscard]] LoopRange& loop() { return loop_; }
  [[nodiscard]] const LoopRange& loop() const { return loop_; }
  [[nodiscard]] WhileDrawing& while_drawing() { return while_drawing_; }
  [[nodiscard]] const WhileDrawing& while_drawing() const { return while_drawing_; }

  [[nodiscard]] bool playing() const { return playing_; }
  /// Plays, or stops.
  void play_or_stop();
  /// Stops on the nearest frame, and takes its pose.
  void stop();
  /// The moment at which the timeline ends: that of its last key, of any character or of the camera, or the end of the
  /// sound beside it.
  [[nodiscard]] double last_s() const;
  void sounds_until(double time_s) { sound_end_s_ = time_s; }
  /// When the last key of other characters is.
  void others_end(double time_s) { others_end_s_ = time_s; }
  /// What is heard now is of this moment: the cursor goes along with it, without a jump where it is less than half a
  /// frame away.
  void hear(double time_s, std::int64_t now_us);
  /// Plays on up to a moment of the clock, microseconds.
  void advance(std::int64_t now_us);

  /// The moment of the pose that is shown; nothing while it plays.
  [[nodiscard]] std::optional<double> shown_moment() const;

  void scrub(double time_s);
  [[nodiscard]] bool scrubs() const { return scrubs_; }
  /// Whether a pose that is on no key is carried along when one goes elsewhere in time, which is the usual; else it is
  /// left behind.
  void carry_poses(bool on) { carries_ = on; }
  void end_scrub();
  /// Goes to the frame nearest to a moment, or to the key that is there, as scrubbing and letting go does.
  void go_to(double time_s);
  /// Goes to the key before (-1) or after (1).
  void step_key(int direction);

  // Steps of the document, with which the cursor goes.
  void undo();
  void redo();
  /// Undoes or redoes until so many commands are done.
  void go_to_step(std::size_t commands);

  /// Another document was opened.
  void begin();
  /// Another character is worked on, at the moment that is shown.
  void take_over();

 private:
  void follow_time(double was_s);
  /// Where the cursor is at a moment of the clock, if it goes on from where it began.
  [[nodiscard]] double played_s(std::int64_t now_us) const {
    return play_from_s_ + speed_ * static_cast<double>(now_us - play_from_us_) * 1e-6;
  }
  /// The nearest frame; a key that lies between two stays where it is.
  [[nodiscard]] double settled(double time_s) const;

  Clock clock_;
  EditingSession& editing_;
  Notices& notices_;
  Preferences& preferences_;
  double time_s_ = 0;
  int rate_ = k_usual_rate;
  LoopRange loop_;
  WhileDrawing while_drawing_;
  double speed_ = 1;
  bool playing_ = false;
  bool scrubs_ = false;  ///< the timeline's pose is shown, and not taken yet
  bool carries_ = true;
  double sound_end_s_ = 0;
  double others_end_s_ = 0;
  double play_from_s_ = 0;
  std::int64_t play_from_us_ = 0;
};

}  // namespace penpose::app
