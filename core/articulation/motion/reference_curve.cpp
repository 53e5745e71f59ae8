#include "core/articulation/motion/reference_curve.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/articulation/region/under_stroke.h"
#include "core/curve/polyline.h"
#include "core/curve/projection.h"
#include "core/geometry/bvh.h"

namespace penpose::articulation {
namespace {

/// A drawn line is cast onto the mesh at this many places, whatever the pen's rate was: what is light smoothing then
/// does not depend on the tablet, and a line given by a few corners follows the surface between them.
constexpr std::size_t k_drawn_samples = 128;

}  // namespace

base::Result<std::vector<ModelPoint>> infer_reference(const Canvas& canvas, const Region& region,
                                                      std::span<const std::uint32_t> specific, std::size_t count) {
  PxBox box;
  for (const std::uint32_t i : specific) box.add(region.seen[i]);
  const bool upright = box.maximum.y - box.minimum.y > box.maximum.x - box.minimum.x;
  std::vector<std::uint32_t> order(specific.begin(), specific.end());
  const auto key = [&](std::uint32_t i) { return upright ? region.seen[i].y : region.seen[i].x; };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
  std::vector<ModelPoint> points;
  for (const std::uint32_t i : order) points.push_back(canvas.positions()[region.vertices[i]]);
  points = curve::triangle_filter<ModelPoint>(points, std::max<std::size_t>(points.size() / 3, 3), curve::Ends::moving);
  points = curve::triangle_filter<ModelPoint>(points, k_light_kernel, curve::Ends::moving);
  auto even = curve::resample<ModelPoint>(points, count);
  if (even) return even;
  return base::Error{"no reference curve can be inferred from so few vertices", "",
                     "draw a larger specific region, or draw the reference curve"};
}

base::Result<std::vector<ModelPoint>> drawn_reference(const Canvas& canvas, const geometry::Camera& camera,
                                                      std::span<const PxPoint> stroke, std::size_t count) {
  const auto dense = curve::resample<PxPoint>(stroke, k_drawn_samples);
  if (!dense) return dense.error();
  const auto triangles = triangles_under(canvas, camera, *dense);
  if (triangles.empty()) return base::Error{"the line does not touch the mesh", "", "draw it over the model"};
  std::vector<glm::vec3> positions;
  positions.reserve(canvas.positions().size());
  for (const ModelPoint& p : canvas.positions()) positions.emplace_back(p);
  const geometry::TriangleBvh surface(positions, triangles, geometry::TriangleBvh::Build::quick);
  const auto projected = curve::project_stroke(*dense, camera, surface);
  if (!projected) return projected.error();
  const auto smooth = curve::triangle_filter<ModelPoint>(projected->positions, k_light_kernel, curve::Ends::fixed);
  return curve::resample<ModelPoint>(smooth, count);
}

namespace {

/// How far a point lies from the rest of the region, where the specific part is attached to the model.
double from_attachment(const ModelPoint& point, const Canvas& canvas, const Region& region,
                       std::span<const std::uint32_t> specific) {
  double least = std::numeric_limits<double>::infinity();
  auto inside = specific.begin();
  for (std::uint32_t i = 0; i < region.vertices.size(); ++i) {
    if (inside != specific.end() && *inside == i) {
      ++inside;
      continue;
    }
    least = std::min(least, geometry::distance(canvas.positions()[region.vertices[i]], point));
  }
  return least;
}

}  // namespace

void begin_where_attached(const Canvas& canvas, const Region& region, std::span<const std::uint32_t> specific,
                          const geometry::Camera& camera, std::span<const PxPoint> target,
                          std::vector<ModelPoint>& reference) {
  constexpr double k_attached = 0.4;  // of the other end's way to what stays
  const auto first = camera.project(reference.front());
  const auto last = camera.project(reference.back());
  if (!first || !last || target.size() < 2) return;
  const auto nearer = [&](PxPoint end) {
    return geometry::distance(target.front(), end) < geometry::distance(target.back(), end);
  };
  if (nearer(*first) != nearer(*last)) return;
  if (from_attachment(reference.back(), canvas, region, specific) <
      k_attached * from_attachment(reference.front(), canvas, region, specific))
    std::reverse(reference.begin(), reference.end());
}

base::Result<SheetReference> sheet_reference(const Canvas& canvas, const geometry::Camera& camera,
                                             std::span<const PxPoint> stroke, std::size_t count,
                                             curve::SheetChoice choice, const MeantTriangles& meant) {
  const double around = (curve::k_farthest_stick + 1.0) * curve::k_stick_px * camera.viewport().height / 1000.0;
  auto triangles = triangles_under(canvas, camera, stroke, around);
  if (meant) std::erase_if(triangles, [&](const mesh::Triangle& t) { return !meant(t); });
  if (triangles.empty()) return base::Error{"the line does not touch the mesh", "", "draw it over the model"};
  std::vector<glm::vec3> positions;
  positions.reserve(canvas.positions().size());
  for (const ModelPoint& p : canvas.positions()) positions.emplace_back(p);
  const geometry::TriangleBvh tree(positions, triangles, geometry::TriangleBvh::Build::quick);
  curve::Sheets sheets(canvas.mesh(), triangles);
  const auto drawn = curve::sheet_curve(stroke, k_drawn_samples, camera, {tree, positions, triangles, sheets}, choice);
  if (!drawn) return drawn.error();
  const auto smooth = curve::triangle_filter<ModelPoint>(drawn->positions, k_light_kernel, curve::Ends::fixed);
  auto even = curve::resample<ModelPoint>(smooth, count);
  if (!even) return even.error();
  SheetReference reference{std::move(*even), {}, 1};
  const auto along = curve::cumulative_length<ModelPoint>(smooth);
  for (std::size_t i = 0; i < count; ++i) {
    ModelVector aside{0};
    if (!drawn->aside.empty()) {
      const auto place = curve::place_at(along, static_cast<double>(i) / static_cast<double>(count - 1));
      aside = drawn->aside[place.segment] * (1.0 - place.fraction) + drawn->aside[place.segment + 1] * place.fraction;
    }
    reference.aside.push_back(aside);
  }
  reference.kept = 1.0 - static_cast<double>(drawn->dropped) / static_cast<double>(stroke.size());
  return reference;
}

}  // namespace penpose::articulation
