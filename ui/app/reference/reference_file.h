#pragma once

#include <atomic>
#include <cstddef>
#include <future>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/state_hash.h"
#include "ui/film/read_film.h"

namespace penpose::app {

/// Films are no larger than this, bytes.
inline constexpr std::uint64_t k_most_film_bytes = std::uint64_t{1} << 29;

/// A reference as it lies on the disk.
struct ReferenceFile {
  base::Hash128 content;
  std::vector<std::string> frames;  ///< pictures, one a frame of the timeline
  bool cut = false;                 ///< a film of which only the beginning was taken
};

/// The hash of a picture's bytes and the numbered pictures beside it; of a film nothing, it takes longer (FilmReader).
/// Errors of the file system.
[[nodiscard]] base::Result<ReferenceFile> open_reference_picture(const std::string& path);

/// Whether the file at a path begins like a film.
[[nodiscard]] bool is_film_file(const std::string& path);

/// Reads a film into pictures beside what goes on in the window, or finds those that were read before.
class FilmReader {
 public:
  /// `cache`: the folder of all films' pictures, of which the eight that were used last are kept.
  FilmReader(const std::string& path, int rate, const std::string& cache);
  /// What is not done is given up.
  ~FilmReader();
  FilmReader(const FilmReader&) = delete;
  FilmReader& operator=(const FilmReader&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }
  /// Pictures that are read.
  [[nodiscard]] std::size_t done() const { return done_; }
  void cancel() { stops_ = true; }
  [[nodiscard]] bool cancelled() const { return stops_; }
  [[nodiscard]] bool ready() const;
  /// Waits for it. Errors: of the file, of ffmpeg, given up.
  [[nodiscard]] base::Result<ReferenceFile> take() { return read_.get(); }

 private:
  std::string path_;
  std::atomic<std::size_t> done_ = 0;
  std::atomic<bool> stops_ = false;
  std::future<base::Result<ReferenceFile>> read_;
};

}  // namespace penpose::app
