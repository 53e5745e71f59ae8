#pragma once

#include <atomic>
#include <cstddef>
#include <string>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "ui/film/ffmpeg.h"

namespace penpose::film {

/// Whether bytes begin a film that can be read: MP4, MOV, WebM, Matroska, AVI or GIF.
[[nodiscard]] bool is_film(base::Bytes bytes);

/// How much of a film is taken as pictures.
struct FilmBounds {
  std::size_t pictures = 2400;
  int side_px = 960;                             ///< of the longer side of a picture
  std::uint64_t bytes = std::uint64_t{1} << 29;  ///< of all pictures
  double seconds = 180;                          ///< that reading may take
};

/// The pictures of a film, one a frame of a timeline.
struct FilmPictures {
  std::vector<std::string> files;  ///< JPEG, in their order
  bool cut = false;                ///< the film goes on, beyond FilmBounds
};

/// Lets ffmpeg write the pictures of a film into a folder that is made, `rate` a second. `done` counts them meanwhile.
/// Errors: no ffmpeg, it failed, nothing came of it, given up.
[[nodiscard]] base::Result<FilmPictures> read_film(const std::string& path, double rate, const std::string& folder,
                                                   const FilmBounds& bounds, const Stop& stop,
                                                   std::atomic<std::size_t>& done);

}  // namespace penpose::film
