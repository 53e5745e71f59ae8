#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/portrait/contour/seen_contours.h"

namespace penpose::portrait {

/// Points of a line at even distances.
struct EvenLine {
  std::vector<PxPoint> points;  ///< at least two
  double spacing = 1;           ///< px
};

/// How far a hand strays from the contour that it means, px of a view 1000 px high.
inline constexpr double k_contour_doubt_px = 3.0;
/// Points so far along a line tell of its pose independently of each other, px.
inline constexpr double k_contour_look_px = 30.0;

/// The doubt of a place so far (px) from where it was drawn, times 1 / looks: rho = k log(1 + (d / sigma)^2 / k), the
/// likelihood of normal errors of unknown width.
[[nodiscard]] double contour_doubt(double distance_px);
/// d rho / d (d / sigma)^2: how much the square counts there.
[[nodiscard]] double contour_weight(double distance_px);

/// A place on a seen contour.
struct ContourPlace {
  std::size_t line = 0;  ///< of SeenContours::lines
  std::size_t segment = 0;
  double share = 0;  ///< of the segment
  PxPoint px;
  PxPoint normal;  ///< to the contour, length one
};

/// Which places of the contours a drawn line is.
struct ContourMatch {
  std::vector<std::optional<ContourPlace>> places;  ///< one a point; none: no contour is near
  double doubt = 0;                                 ///< of all points, and of places where the line leaves a contour
};

/// The likeliest way to go along the contours while the line is drawn (Viterbi): each point is at the nearest part of a
/// contour of like direction, and the next one farther along it by as much as was drawn, or where another contour goes
/// on. The line may be drawn either way, but not there and back.
[[nodiscard]] ContourMatch match_contour(const EvenLine& line, std::span<const SeenContour> contours);

}  // namespace penpose::portrait
