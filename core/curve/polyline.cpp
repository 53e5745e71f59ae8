#include "core/curve/polyline.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace penpose::curve {
namespace {

bool finite(const PxPoint& p) { return std::isfinite(p.x) && std::isfinite(p.y); }
bool finite(const ModelPoint& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

template <typename Point>
Point between_points(const Point& a, const Point& b, double t) {
  return a * (1.0 - t) + b * t;
}

template <typename Point>
std::optional<base::Error> check(std::span<const Point> points, double length) {
  if (points.size() < 2) return base::Error{"the curve has fewer than two points", "", "draw a longer line"};
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!finite(points[i]))
      return base::Error{"the curve has a point that is not finite", "point " + std::to_string(i), "draw it again"};
  }
  if (!(length > 0.0) || !std::isfinite(length))
    return base::Error{"the curve has no length", "", "draw a longer line"};
  return std::nullopt;
}

template <typename Point>
Point at_place(std::span<const Point> points, const PolylinePlace& place) {
  return between_points(points[place.segment], points[place.segment + 1], place.fraction);
}

}  // namespace

template <CurveSpace Point>
std::vector<double> cumulative_length(std::span<const Point> points) {
  std::vector<double> lengths;
  lengths.reserve(points.size());
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) sum += geometry::distance(points[i - 1], points[i]);
    lengths.push_back(sum);
  }
  return lengths;
}

template <CurveSpace Point>
double arc_length(std::span<const Point> points) {
  return points.empty() ? 0.0 : cumulative_length(points).back();
}

PolylinePlace place_at(std::span<const double> cumulative, double share) {
  const double wanted = share * cumulative.back();
  const auto after = std::upper_bound(cumulative.begin() + 1, cumulative.end() - 1, wanted);
  const auto segment = static_cast<std::size_t>(after - cumulative.begin()) - 1;
  const double length = cumulative[segment + 1] - cumulative[segment];
  const double fraction = length > 0.0 ? (wanted - cumulative[segment]) / length : 0.0;
  return {segment, std::clamp(fraction, 0.0, 1.0)};
}

template <CurveSpace Point>
base::Result<std::vector<Point>> resample_at(std::span<const Point> points, std::span<const double> shares) {
  const auto cumulative = cumulative_length(points);
  if (auto error = check(points, cumulative.empty() ? 0.0 : cumulative.back())) return *error;
  std::vector<Point> result;
  result.reserve(shares.size());
  for (const double share : shares) {
    if (share <= 0.0) {
      result.push_back(points.front());
    } else if (share >= 1.0) {
      result.push_back(points.back());
    } else {
      result.push_back(at_place(points, place_at(cumulative, share)));
    }
  }
  return result;
}

template <CurveSpace Point>
base::Result<std::vector<Point>> resample(std::span<const Point> points, std::size_t count) {
  if (count < 2) return base::Error{"a curve needs at least two points", "", "ask for two or more"};
  std::vector<double> shares(count);
  for (std::size_t i = 0; i < count; ++i) shares[i] = static_cast<double>(i) / static_cast<double>(count - 1);
  return resample_at(points, shares);
}

template <CurveSpace Point>
base::Result<std::vector<double>> shares_of(std::span<const Point> points) {
  auto cumulative = cumulative_length(points);
  if (auto error = check(points, cumulative.empty() ? 0.0 : cumulative.back())) return *error;
  const double length = cumulative.back();
  for (double& entry : cumulative) entry /= length;
  return cumulative;
}

namespace {

/// From this many points under a kernel on, sums of sums are quicker than adding up every kernel.
constexpr std::int64_t k_wide = 128;

/// The filter in time linear in the points, whatever the kernel is: with the sums S of the points and T of the points
/// times their numbers, rising and falling side of a kernel are both differences of S and T.
template <CurveSpace Point>
void filter_wide(std::span<const Point> points, std::int64_t half, std::vector<Point>& result) {
  const auto count = static_cast<std::int64_t>(points.size());
  std::vector<Point> sums(points.size() + 1, Point{});
  std::vector<Point> moments(points.size() + 1, Point{});
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Point off = points[k] - points[0];
    sums[k + 1] = sums[k] + off;
    moments[k + 1] = moments[k] + off * static_cast<double>(k);
  }
  const auto top = static_cast<double>(half + 1);
  for (std::int64_t i = 0; i < count; ++i) {
    const std::int64_t from = std::max<std::int64_t>(0, i - half);
    const std::int64_t to = std::min(count - 1, i + half);
    const auto first = static_cast<std::size_t>(from);
    const auto after = static_cast<std::size_t>(i) + 1;
    const auto end = static_cast<std::size_t>(to) + 1;
    const auto here = static_cast<double>(i);
    const Point rising = (sums[after] - sums[first]) * (top - here) + (moments[after] - moments[first]);
    const Point falling = (sums[end] - sums[after]) * (top + here) - (moments[end] - moments[after]);
    const auto left = static_cast<double>(i - from);
    const auto right = static_cast<double>(to - i);
    const double weights = top * (left + right + 1) - 0.5 * (left * (left + 1) + right * (right + 1));
    result[static_cast<std::size_t>(i)] = points[0] + (rising + falling) * (1.0 / weights);
  }
}

}  // namespace

template <CurveSpace Point>
std::vector<Point> triangle_filter(std::span<const Point> points, std::size_t kernel, Ends ends) {
  // 64 bits on every machine: weights are whole numbers of up to the kernel's size.
  constexpr std::uint64_t k_widest = std::uint64_t{1} << 48U;
  const auto half = static_cast<std::int64_t>(std::clamp<std::uint64_t>(kernel, 3, k_widest) / 2);
  const auto count = static_cast<std::int64_t>(points.size());
  std::vector<Point> result(points.begin(), points.end());
  if (std::min(half, count) >= k_wide) {
    filter_wide(points, half, result);
    if (ends == Ends::fixed) {
      result.front() = points.front();
      result.back() = points.back();
    }
    return result;
  }
  for (std::int64_t i = 0; i < count; ++i) {
    if (ends == Ends::fixed && (i == 0 || i == count - 1)) continue;
    Point sum{};
    double weights = 0;
    for (std::int64_t k = std::max<std::int64_t>(0, i - half); k <= std::min(count - 1, i + half); ++k) {
      const auto weight = static_cast<double>(half + 1 - std::abs(k - i));
      sum = sum + points[static_cast<std::size_t>(k)] * weight;
      weights += weight;
    }
    result[static_cast<std::size_t>(i)] = sum * (1.0 / weights);
  }
  return result;
}

template std::vector<double> cumulative_length<PxPoint>(std::span<const PxPoint>);
template double arc_length<PxPoint>(std::span<const PxPoint>);
template base::Result<std::vector<PxPoint>> resample<PxPoint>(std::span<const PxPoint>, std::size_t);
template base::Result<std::vector<PxPoint>> resample_at<PxPoint>(std::span<const PxPoint>, std::span<const double>);
template base::Result<std::vector<double>> shares_of<PxPoint>(std::span<const PxPoint>);
template std::vector<PxPoint> triangle_filter<PxPoint>(std::span<const PxPoint>, std::size_t, Ends);

template std::vector<double> cumulative_length<ModelPoint>(std::span<const ModelPoint>);
template double arc_length<ModelPoint>(std::span<const ModelPoint>);
template base::Result<std::vector<ModelPoint>> resample<ModelPoint>(std::span<const ModelPoint>, std::size_t);
template base::Result<std::vector<ModelPoint>> resample_at<ModelPoint>(std::span<const ModelPoint>,
                                                                       std::span<const double>);
template base::Result<std::vector<double>> shares_of<ModelPoint>(std::span<const ModelPoint>);
template std::vector<ModelPoint> triangle_filter<ModelPoint>(std::span<const ModelPoint>, std::size_t, Ends);

}  // namespace penpose::curve
