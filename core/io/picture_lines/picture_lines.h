#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/space.h"

namespace penpose::io {

/// How the names of lines begin that are contours of a model: "silhouette", "silhouette_0".
inline constexpr std::string_view k_contour_name = "silhouette";

/// A line of a drawing, as a pen would draw it: at least two points, one after the other.
struct PictureLine {
  std::vector<geometry::PxPoint> points;  ///< of a closed line the last is the first again
  bool closed = false;
  /// The number of the element that it was drawn with, from 0: an SVG's visible shapes in the order in which they are
  /// drawn, of which one may have several lines or none; every line of a picture in px is one of its own.
  std::size_t element = 0;
  std::string name;  ///< the `id` of that element; empty where it has none
};

/// The lines of a drawing, in px from its upper left corner.
struct PictureLines {
  std::vector<PictureLine> lines;
  double width = 0;  ///< of the drawing (px)
  double height = 0;
};

}  // namespace penpose::io
