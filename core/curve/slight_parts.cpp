#include "core/curve/slight_parts.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "core/curve/polyline.h"
#include "core/geometry/closest_point.h"

namespace penpose::curve {
namespace {

/// Triangles of one part near a line.
struct Part {
  std::uint32_t component = 0;
  double area = 0;
  std::vector<std::uint32_t> triangles;
};

/// The parts that are not slight and come within reach of a box, the largest first.
std::vector<Part> bodies_near(const geometry::Box& box, double reach, const SheetSurface& surface) {
  const double least = k_slight * surface.sheets.largest_area();
  std::vector<Part> parts;
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    if (!(surface.sheets.area(t) >= least)) continue;
    geometry::Box own;
    for (const std::uint32_t v : surface.triangles[t]) own.add(ModelPoint(surface.positions[v]));
    bool apart = false;
    for (int axis = 0; axis < 3; ++axis) {
      apart = apart || own.minimum[axis] > box.maximum[axis] + reach || own.maximum[axis] < box.minimum[axis] - reach;
    }
    if (apart) continue;
    const std::uint32_t component = surface.sheets.component(t);
    auto part = std::find_if(parts.begin(), parts.end(), [&](const Part& one) { return one.component == component; });
    if (part == parts.end()) part = parts.insert(parts.end(), {component, surface.sheets.area(t), {}});
    part->triangles.push_back(t);
  }
  std::stable_sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.area > b.area; });
  return parts;
}

/// The nearest place of a part to each point; nothing where one of them is farther than the reach.
std::optional<std::vector<geometry::ClosestPoint>> places_on(const Part& part, std::span<const ModelPoint> points,
                                                             double reach, const SheetSurface& surface) {
  std::vector<ModelPoint> corners;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const std::uint32_t t : part.triangles) {
    const auto first = static_cast<std::uint32_t>(corners.size());
    for (const std::uint32_t v : surface.triangles[t]) corners.emplace_back(surface.positions[v]);
    triangles.push_back({first, first + 1, first + 2});
  }
  const geometry::ClosestPointTree tree(corners, triangles);
  std::vector<geometry::ClosestPoint> places;
  for (const ModelPoint& point : points) {
    places.push_back(tree.closest(point));
    if (!(places.back().distance <= reach)) return std::nullopt;
    places.back().triangle = part.triangles[places.back().triangle];
  }
  return places;
}

}  // namespace

void stand_on_body(ProjectedStroke& drawn, const SheetSurface& surface) {
  const double least = k_slight * surface.sheets.largest_area();
  std::vector<std::size_t> slight;
  std::vector<ModelPoint> points;
  geometry::Box box;
  for (std::size_t i = 0; i < drawn.points.size(); ++i) {
    if (surface.sheets.area(drawn.points[i].triangle) >= least) continue;
    slight.push_back(i);
    points.push_back(drawn.positions[i]);
    box.add(drawn.positions[i]);
  }
  if (slight.empty()) return;
  const double reach = k_stand * arc_length<ModelPoint>(drawn.positions);
  for (const Part& part : bodies_near(box, reach, surface)) {
    const auto places = places_on(part, points, reach, surface);
    if (!places) continue;
    if (drawn.aside.empty()) drawn.aside.assign(drawn.points.size(), geometry::ModelVector{0});
    for (std::size_t k = 0; k < slight.size(); ++k) {
      const geometry::ClosestPoint& place = (*places)[k];
      const std::size_t i = slight[k];
      drawn.aside[i] += drawn.positions[i] - place.point;
      drawn.points[i] = {place.triangle, place.barycentric};
      drawn.positions[i] = place.point;
    }
    return;
  }
}

}  // namespace penpose::curve
