#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/camera.h"
#include "ui/film/ffmpeg.h"
#include "ui/film/film_kind.h"
#include "ui/film/film_sound.h"
#include "ui/render/picture/image.h"

namespace penpose::film {

/// What is written where.
struct FilmPlan {
  FilmKind kind = FilmKind::mp4;
  std::string output;       ///< a file; of pictures their common name (frame_name)
  geometry::Viewport size;  ///< of each picture, px
  double rate = 24;         ///< frames a second
  std::vector<int> frames;  ///< of a sheet any; of all others one after the other
  bool numbers = false;     ///< each picture has its frame's number in it; a sheet has them beneath
};

/// Draws the picture of a frame, of the plan's size.
using DrawFrame = std::function<base::Result<render::Image>(int frame)>;

/// Whoever waits for a film.
struct Waiting {
  std::function<void(std::size_t done, std::size_t all)> progress;  ///< pictures that are drawn
  Stop stop;
};

/// A GIF counts hundredths of a second, and no program shows more pictures a second than this.
inline constexpr double k_most_gif_rate = 50;

/// Draws and writes a film. `sound`: null for none, and left out by kinds without sound. The output appears under its
/// name when it is complete, and never where this fails. Errors: of drawing, of the file system, given_up, no ffmpeg
/// where the kind needs it, or it failed.
[[nodiscard]] base::Status write_film(const FilmPlan& plan, const DrawFrame& draw, const PlacedSound* sound,
                                      const Waiting& waiting);

}  // namespace penpose::film
