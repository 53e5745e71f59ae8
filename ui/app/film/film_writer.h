#pragma once

#include <memory>
#include <string>
#include <utility>

#include "ui/app/canvas/canvas.h"
#include "ui/app/files/files.h"
#include "ui/app/film/film_entry.h"
#include "ui/app/film/film_job.h"
#include "ui/app/notices.h"
#include "ui/app/playback/playback.h"
#include "ui/app/preferences.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/sound/sound_track.h"
#include "ui/files/process/own_program.h"

namespace penpose::app {

/// The film that is being written, one at a time.
class FilmWriter {
 public:
  /// What a film is of.
  struct With {
    EditingSession& editing;
    Notices& notices;
    const Canvas& canvas;
    const CanvasLook& look;
    const Playback& playback;
    const SoundTrack& sound;
    const Files& files;
    const Preferences& preferences;
    const Cast& cast;
  };
  explicit FilmWriter(const With& with) : with_(with) {}

  /// Another program than this one writes them.
  void use_program(std::string program) { program_ = std::move(program); }

  /// The first and the last frame of a range.
  [[nodiscard]] std::pair<int, int> frames_of(FilmRange range) const;
  /// How large a picture of it is, px; on a sheet each of its pictures.
  [[nodiscard]] geometry::Viewport size_of(const FilmEntry& entry) const;
  /// The document has a sound that cannot be opened: films are silent.
  [[nodiscard]] bool lacks_sound() const;

  /// Writes a film of the timeline as it is seen now; it goes on beside. False, and said why, where it cannot begin.
  bool write(const std::string& path, const FilmEntry& entry);
  /// Writes what is played as the canvas shows it, with the numbers of its frames, into a new file beside the project
  /// (film_folder). Without ffmpeg: its pictures, in a folder there.
  void playblast();
  [[nodiscard]] bool writes() const { return job_ != nullptr; }
  [[nodiscard]] const FilmJob* job() const { return job_.get(); }
  /// Gives the film up.
  void cancel();
  /// Goes on, and says so once it is written.
  void follow();

 private:
  With with_;
  std::string program_ = files::own_program();
  std::unique_ptr<FilmJob> job_;
};

}  // namespace penpose::app
