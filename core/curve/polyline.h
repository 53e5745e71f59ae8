#pragma once

#include <concepts>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/curve/stroke.h"

namespace penpose::curve {

/// The point of a polyline: px or model space.
template <typename Point>
concept CurveSpace = std::same_as<Point, PxPoint> || std::same_as<Point, ModelPoint>;

/// Length from the first point to each point; the last entry is the length of the whole. Empty for no points.
template <CurveSpace Point>
[[nodiscard]] std::vector<double> cumulative_length(std::span<const Point> points);

template <CurveSpace Point>
[[nodiscard]] double arc_length(std::span<const Point> points);

/// A place on a polyline: segment k runs from point k to point k + 1, at `fraction` 0..1 of it.
struct PolylinePlace {
  std::size_t segment = 0;
  double fraction = 0;
};
/// The place at a share 0..1 of the length. Precondition: `cumulative` is of at least two points and of positive
/// length.
[[nodiscard]] PolylinePlace place_at(std::span<const double> cumulative, double share);

/// Arc-length reparameterisation to `count` points: point i (1..count) sits at fraction (i - 1)/(count - 1) of the
/// length (method, section 1; the paper's equation 1 prints (i - 1)/n, which never reaches the end). Both ends are kept
/// exactly. Errors: fewer than two points on either side, a curve of zero length, coordinates that are not finite.
template <CurveSpace Point>
[[nodiscard]] base::Result<std::vector<Point>> resample(std::span<const Point> points, std::size_t count);

/// Points at given shares (0..1, any order) of the length. Errors as resample.
template <CurveSpace Point>
[[nodiscard]] base::Result<std::vector<Point>> resample_at(std::span<const Point> points,
                                                           std::span<const double> shares);

/// The share of the length at which each point lies. Errors as resample.
template <CurveSpace Point>
[[nodiscard]] base::Result<std::vector<double>> shares_of(std::span<const Point> points);

enum class Ends { fixed, moving };

/// Triangle filter with an odd kernel of at least 3: weights fall linearly from the centre to zero just past the
/// kernel's edge and sum to one; near the ends the kernel is cut and renormalised. An even or smaller kernel is raised
/// to the next odd one. Ends stay for curves that were drawn, and move for curves that were estimated from vertices.
template <CurveSpace Point>
[[nodiscard]] std::vector<Point> triangle_filter(std::span<const Point> points, std::size_t kernel, Ends ends);

}  // namespace penpose::curve
