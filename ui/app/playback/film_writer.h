#pragma once

#include <memory>
#include <string>

#include "ui/app/canvas/canvas.h"
#include "ui/app/dialogs/film_job.h"
#include "ui/app/notices.h"
#include "ui/app/playback/playback.h"
#include "ui/app/session/editing_session.h"

namespace penpose::app {

/// The film that is being written, one at a time.
class FilmWriter {
 public:
  FilmWriter(EditingSession& editing, Notices& notices, const Canvas& canvas, const Playback& playback);

  /// Writes a film of what is keyed, seen from where one looks; it goes on beside. False, and said why, where it
  /// cannot begin.
  bool write(const std::string& path, geometry::Viewport size);
  [[nodiscard]] bool writes() const { return job_ != nullptr; }
  /// Goes on, and says so once it is written.
  void follow();

 private:
  EditingSession& editing_;
  Notices& notices_;
  const Canvas& canvas_;
  const Playback& playback_;
  std::unique_ptr<FilmJob> job_;
};

}  // namespace penpose::app
