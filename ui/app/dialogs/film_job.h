#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

#include "core/base/result.h"
#include "core/document/document.h"

namespace penpose::app {

/// What a film is made of.
struct FilmOrder {
  std::string output;  ///< .mp4, or .png: pictures NAME0001.png, NAME0002.png, ...
  geometry::CameraPose camera;
  geometry::Viewport size{1280, 720};
  int rate = 24;  ///< frames a second
};

/// Whether ffmpeg is there to make an .mp4 file.
[[nodiscard]] bool has_ffmpeg();

/// Writes a film beside what goes on in the window: this program draws the pictures in a process of its own, ffmpeg
/// joins them in another.
class FilmJob {
 public:
  /// Errors: nothing is keyed, no place for what lies in between, no ffmpeg for an .mp4.
  static base::Result<FilmJob> start(const document::Document& document, const FilmOrder& order);
  FilmJob(FilmJob&& other) noexcept;
  FilmJob& operator=(FilmJob&& other) = delete;
  /// What is not done is given up.
  ~FilmJob();

  /// Goes on where a process has ended. Done: the film is there; an error: it will not be; nothing yet otherwise.
  [[nodiscard]] std::optional<base::Status> advance();
  [[nodiscard]] const std::string& output() const { return order_.output; }

 private:
  FilmJob() = default;
  base::Status run(const std::vector<std::string>& words);

  FilmOrder order_;
  std::string folder_;  ///< of what lies in between; gone at the end
  pid_t process_ = -1;
  bool joins_ = false;  ///< ffmpeg is at work
};

}  // namespace penpose::app
