#include "core/document/drawing/target_line.h"

#include <algorithm>
#include <cmath>

#include "core/curve/pairing.h"
#include "core/curve/polyline.h"
#include "core/posing/problem.h"

namespace penpose::document {
namespace {

using curve::PxPoint;

/// Values that are given at the points of a line, at shares of its length.
std::vector<double> values_at(std::span<const PxPoint> line, std::span<const double> values,
                              std::span<const double> shares) {
  if (values.empty()) return std::vector<double>(shares.size(), 1.0);
  const std::vector<double> cumulative = curve::cumulative_length(line);
  std::vector<double> out;
  for (const double share : shares) {
    const curve::PolylinePlace place = curve::place_at(cumulative, share);
    const double a = values[place.segment];
    const double b = values[std::min(place.segment + 1, values.size() - 1)];
    out.push_back(a + (b - a) * place.fraction);
  }
  return out;
}

std::vector<double> even_shares(std::size_t count) {
  std::vector<double> shares;
  for (std::size_t i = 0; i < count; ++i) shares.push_back(static_cast<double>(i) / static_cast<double>(count - 1));
  return shares;
}

double distance_to_segment(PxPoint p, PxPoint from, PxPoint to) {
  return geometry::distance(p, from + (to - from) * geometry::nearest_share(p, from, to));
}

/// Which side of the line through two points a third lies on.
double side(PxPoint from, PxPoint to, PxPoint p) {
  return (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
}

bool cross(PxPoint a, PxPoint b, PxPoint c, PxPoint d) {
  return side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0;
}

/// The segment from point i; a line of one point has one segment of no length.
std::pair<PxPoint, PxPoint> segment(std::span<const PxPoint> line, std::size_t i) {
  return {line[i], line[std::min(i + 1, line.size() - 1)]};
}

std::size_t segment_count(std::span<const PxPoint> line) { return line.size() < 2 ? line.size() : line.size() - 1; }

}  // namespace

base::Result<DrawnTarget> make_target(std::span<const geometry::ModelPoint> reference, const View& view,
                                      std::span<const PxPoint> line, std::span<const double> pressure) {
  if (!pressure.empty() && pressure.size() != line.size()) {
    return base::Error{"there are not as many pressures as points", "pressure", "give one a point, or none"};
  }
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  if (!camera) return camera.error();
  auto paired = curve::pair_target(reference, line, *camera);
  if (!paired) return paired.error();
  auto even = curve::resample(line, k_line_points);
  if (!even) return even.error();
  DrawnTarget target;
  target.view = view;
  target.line = std::move(even).value();
  target.pressure = values_at(line, pressure, even_shares(k_line_points));
  target.points = std::move(paired->points);
  target.weights = posing::pressure_weights(values_at(line, pressure, paired->shares));
  return target;
}

std::vector<bool> untouched(const DrawnTarget& before, const DrawnTarget& after) {
  std::vector<bool> stays;
  for (std::size_t i = 0; i < before.points.size(); ++i)
    stays.push_back(i < after.points.size() && before.points[i] == after.points[i]);
  const auto count = static_cast<std::size_t>(std::count(stays.begin(), stays.end(), true));
  if (count == 0 || count == stays.size()) stays.clear();
  return stays;
}

bool come_near(std::span<const PxPoint> a, std::span<const PxPoint> b, double distance_px) {
  for (std::size_t i = 0; i < segment_count(a); ++i) {
    const auto [a0, a1] = segment(a, i);
    for (std::size_t j = 0; j < segment_count(b); ++j) {
      const auto [b0, b1] = segment(b, j);
      if (cross(a0, a1, b0, b1) || distance_to_segment(a0, b0, b1) <= distance_px ||
          distance_to_segment(a1, b0, b1) <= distance_px || distance_to_segment(b0, a0, a1) <= distance_px ||
          distance_to_segment(b1, a0, a1) <= distance_px) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace penpose::document
