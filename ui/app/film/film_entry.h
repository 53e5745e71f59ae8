#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/geometry/camera.h"
#include "ui/film/film_kind.h"

namespace penpose::app {

/// Which frames are filmed.
enum class FilmRange : std::uint8_t {
  all,   ///< from the first frame to where the timeline ends, with its sound
  loop,  ///< what is played over and over
  keys,  ///< from the first frame to the last key
};

/// What is chosen for the next film.
struct FilmEntry {
  film::FilmKind kind = film::FilmKind::mp4;
  std::optional<geometry::Viewport> size = geometry::Viewport{1280, 720};  ///< nothing: that of the canvas
  FilmRange range = FilmRange::all;
  bool numbers = false;        ///< in the pictures
  std::optional<int> every{};  ///< of a sheet: every so many frames; nothing: the keyed ones
  std::string asked_of;        ///< a path that would be written over, which was said
};

}  // namespace penpose::app
