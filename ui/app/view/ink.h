#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/space.h"

namespace penpose::app {

using geometry::PxPoint;

// How a drawn line is shown: smoother than the hand, as wide as the pen pressed, pointed at its ends. What is solved
// for is what was drawn.

enum class Stabiliser : std::uint8_t { off, light, strong };

struct InkLine {
  std::vector<PxPoint> points;
  std::vector<float> widths_px;
};

struct InkLook {
  Stabiliser stabiliser = Stabiliser::light;
  float scale = 1;            ///< px of the display for each px of an ordinary one
  float least_px = 2.0F;      ///< width of a line that hardly presses, at scale 1
  float most_px = 7.0F;       ///< and of one that presses as hard as it can
  bool tapers_at_end = true;  ///< the line is done: its end is pointed, too
};

/// The line through samples of a pen. Samples come as densely as the device sends them; the line has a point about
/// every 2 px. Its ends are where the pen began and is. Pressures 0..1; fewer than samples: the rest are 0.5.
[[nodiscard]] InkLine ink_line(std::span<const PxPoint> samples, std::span<const double> pressures,
                               const InkLook& look);

/// Widths along a line of points that ends in points: pressure by arc length, with tapered ends.
[[nodiscard]] std::vector<float> ink_widths(std::span<const PxPoint> points, std::span<const double> pressures,
                                            const InkLook& look);

}  // namespace penpose::app
