#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/sound/peaks.h"
#include "core/sound/sound.h"
#include "ui/app/files/files.h"
#include "ui/app/notices.h"
#include "ui/app/playback/playback.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/sound/sound_output.h"

namespace penpose::app {

/// The sound beside the timeline: its samples, which the document only refers to, and what is heard of them. While the
/// timeline plays its cursor goes along with what is heard, which is lower where it plays slower; a cursor that is
/// moved sounds for a frame.
class SoundTrack {
 public:
  SoundTrack(EditingSession& editing, Notices& notices, Playback& playback, const Files& files);

  /// By what it is heard; none: it is silent.
  void set_output(std::unique_ptr<SoundOutput> output) { output_ = std::move(output); }

  /// Lays a sound beside the timeline, in place of one that is there; what is wrong with it is told.
  void open(const std::string& path);
  void remove();
  /// Lets it begin at another moment of the timeline.
  void move(double offset_s);

  [[nodiscard]] bool muted() const { return muted_; }
  void mute(bool muted) { muted_ = muted; }
  /// Null: there is none, or it cannot be opened.
  [[nodiscard]] const sound::Sound* sound() const { return sound_.get(); }
  /// The same, for whoever goes on with it when it is another one.
  [[nodiscard]] std::shared_ptr<const sound::Sound> shared_sound() const { return sound_; }
  [[nodiscard]] const sound::Peaks& peaks() const { return peaks_; }
  /// The moment of the timeline at which it begins, also while it is dragged.
  [[nodiscard]] double offset_s() const;
  /// The same as the document has it.
  [[nodiscard]] double document_offset_s() const;
  /// Dragged to an offset; nothing: it is no longer.
  void drag(std::optional<double> offset_s) { dragged_s_ = offset_s; }

  /// Brings samples and what is heard up to now.
  void follow(std::int64_t now_us);
  /// Milliseconds until something is to be done without any event; -1: nothing.
  [[nodiscard]] int next_frame_ms() const;

 private:
  void take_document();
  void play(std::int64_t now_us);
  void begin_at(double time_s);
  void sound_frame(std::int64_t now_us);
  [[nodiscard]] bool make_ready();
  void hush();

  EditingSession& editing_;
  Notices& notices_;
  Playback& playback_;
  const Files& files_;
  std::unique_ptr<SoundOutput> output_;
  std::shared_ptr<const document::SoundReference> known_;  ///< that `sound_` is of
  std::string known_project_;
  std::shared_ptr<const sound::Sound> sound_;
  sound::Peaks peaks_;
  std::optional<double> dragged_s_;
  bool muted_ = false;
  bool open_ = false;       ///< the output is
  bool running_ = false;    ///< it plays along
  double heard_speed_ = 1;  ///< that it plays along at
  std::int64_t next_sample_ =
      0;  ///< that comes into the queue next, counted from the timeline's beginning at that speed
  std::optional<double> last_time_s_;
  std::int64_t close_at_us_ = 0;
  std::int64_t now_us_ = 0;
};

}  // namespace penpose::app
