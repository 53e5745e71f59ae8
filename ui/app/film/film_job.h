#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

#include "core/base/result.h"
#include "core/document/document.h"
#include "core/io/project/cast_file.h"
#include "core/sound/sound.h"
#include "ui/app/film/film_view.h"
#include "ui/film/film_kind.h"
#include "ui/render/ghosts/ghost_moments.h"

namespace penpose::app {

/// What a film is made of.
struct FilmOrder {
  std::string program;  ///< whose `film` writes it
  film::FilmKind kind = film::FilmKind::mp4;
  std::string output;  ///< of pictures NAME.png: NAME0000.png, NAME0001.png, ...
  FilmView view;
  bool moves = false;  ///< the document's camera is taken, and of `view` only the picture; FilmJob says so itself
  int rate = 24;       ///< frames a second
  int from = 0;        ///< the first frame
  int to = 0;          ///< the last one
  std::optional<int> every{};  ///< of a sheet: every so many frames; nothing: the keyed ones
  bool numbers = false;
  bool wireframe = false;
  bool clay = false;
  bool matcap = false;
  bool shadows = false;
  std::optional<render::GhostLook> ghosts{};  ///< the face before and after; nothing: it is not shown
  bool light = false;                         ///< the ground behind the model is
  const sound::Sound* sound = nullptr;        ///< null: none
  double sound_offset_s = 0;
  io::Cast characters{};                               ///< all that are seen; without members: one document
  std::vector<const document::Document*> documents{};  ///< one each; no longer read once it has started
};

/// How many pictures of a film are drawn.
struct FilmProgress {
  std::size_t done = 0;
  std::size_t all = 0;  ///< 0: not known yet
};

/// Writes a film beside what goes on in the window: a program's `film`, in a process of its own.
class FilmJob {
 public:
  /// Errors: nothing is keyed, no place for what lies in between, no ffmpeg where the kind needs it.
  static base::Result<FilmJob> start(const document::Document& document, const FilmOrder& order);
  FilmJob(FilmJob&& other) noexcept;
  FilmJob& operator=(FilmJob&& other) = delete;
  /// What is not done is given up.
  ~FilmJob();

  /// Gives up; advance() says when that is done. What was there stays, and nothing is added.
  void cancel();
  [[nodiscard]] bool cancelled() const { return cancelled_; }
  /// Done: the film is there; an error: it will not be; nothing yet otherwise.
  [[nodiscard]] std::optional<base::Status> advance();
  [[nodiscard]] const FilmProgress& progress() const { return progress_; }
  [[nodiscard]] const std::string& output() const { return order_.output; }
  /// The same as it is said of what is done: of pictures the first one.
  [[nodiscard]] std::string written() const;

 private:
  FilmJob() = default;
  base::Status run(const std::vector<std::string>& words);
  void read_progress();
  [[nodiscard]] base::Error failed() const;

  FilmOrder order_;
  std::string folder_;  ///< of what lies in between; gone at the end
  pid_t process_ = -1;
  int says_ = -1;      ///< its standard output
  std::string heard_;  ///< of a line that is not complete
  FilmProgress progress_;
  bool cancelled_ = false;
};

}  // namespace penpose::app
