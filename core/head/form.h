#pragma once

#include <initializer_list>
#include <span>

#include "core/geometry/space.h"

// The head is designed in centimetres: y = 0 at the middle of the eyes, z = 0 at the ears.
namespace penpose::head {

using geometry::ModelPoint;
using geometry::ModelVector;

/// A point of a profile line.
struct Knot {
  double at = 0;
  double value = 0;
};

/// A smooth line through knots in ascending order (cubic Hermite, slopes by finite differences), constant beyond them.
[[nodiscard]] double profile(std::initializer_list<Knot> knots, double at);

/// 0 at `from`, 1 at `to`, smooth between; `from` may be above `to`.
[[nodiscard]] double ramp(double from, double to, double at);

/// 1 at the centre, 0 at distance 1 and beyond, with two continuous derivatives; `distance_square` is squared.
[[nodiscard]] double bump(double distance_square);

/// Where the right half of a control row runs: from the front (0, front_y, front_z) over the side (side_x, side_y,
/// side_z) to the back (0, back_y, back_z), two quarters of a superellipse.
struct Row {
  double front_y, front_z;
  double side_x, side_y, side_z;
  double back_y, back_z;
};

/// The control rows from the hair line down to the foot of the neck, which spreads and turns in under itself, bare of
/// features.
inline constexpr int k_rows = 18;
[[nodiscard]] const Row& row(int number);

/// The point of a row at an angle in degrees: 0 front, 90 side, 180 back.
[[nodiscard]] ModelPoint point_at_angle(const Row& row, double degrees);
/// The point of a row's front quarter at a given x.
[[nodiscard]] ModelPoint point_at_x(const Row& row, double x);
/// Depth of the bare face at (x, y), between the rows that run there.
[[nodiscard]] double bare_depth(double x, double y);

}  // namespace penpose::head
