#include "core/curve/projection.h"

#include <cmath>
#include <optional>

#include "core/curve/polyline.h"

namespace penpose::curve {
namespace {

struct Run {
  std::size_t begin = 0;
  std::size_t end = 0;
  double length_px = 0;
};

/// The longest run of consecutive hits; of equals the first.
Run longest_run(std::span<const PxPoint> stroke, std::span<const std::optional<geometry::RayHit>> hits) {
  Run best;
  Run run;
  for (std::size_t i = 0; i < stroke.size(); ++i) {
    if (!hits[i]) {
      run = {i + 1, i + 1, 0};
      continue;
    }
    if (run.end > run.begin) run.length_px += geometry::distance(stroke[i - 1], stroke[i]);
    run.end = i + 1;
    if (run.length_px > best.length_px || best.end == best.begin) best = run;
    if (run.begin == best.begin) best = run;
  }
  return best;
}

base::Error no_touch() { return {"the line does not touch the mesh", "", "draw it over the model"}; }

}  // namespace

base::Result<ProjectedStroke> project_stroke(std::span<const PxPoint> stroke, const geometry::Camera& camera,
                                             const geometry::TriangleBvh& surface) {
  std::vector<std::optional<geometry::RayHit>> hits(stroke.size());
  std::uint32_t hint = geometry::TriangleBvh::k_no_hint;
  for (std::size_t i = 0; i < stroke.size(); ++i) {
    if (!std::isfinite(stroke[i].x) || !std::isfinite(stroke[i].y)) continue;  // nowhere: it misses
    hits[i] = surface.nearest_hit(camera.ray(stroke[i]), hint);
    if (hits[i]) hint = hits[i]->triangle;
  }
  const Run run = longest_run(stroke, hits);
  ProjectedStroke result;
  for (std::size_t i = run.begin; i < run.end; ++i) {
    if (!result.samples.empty() && stroke[result.samples.back()] == stroke[i]) continue;
    result.points.push_back({hits[i]->triangle, hits[i]->barycentric});
    const geometry::Ray ray = camera.ray(stroke[i]);
    result.positions.push_back(ray.origin + ray.direction * hits[i]->distance);
    result.samples.push_back(i);
  }
  if (result.points.size() < 2) return no_touch();
  result.dropped = stroke.size() - result.points.size();
  return result;
}

base::Result<ProjectedStroke> surface_curve(std::span<const PxPoint> stroke, std::size_t count,
                                            const geometry::Camera& camera, const geometry::TriangleBvh& surface) {
  auto projected = project_stroke(stroke, camera, surface);
  if (!projected) return projected;
  std::vector<PxPoint> line;
  for (const std::size_t i : projected->samples) line.push_back(stroke[i]);
  const auto even = resample<PxPoint>(line, count);
  if (!even) return even.error();
  const auto cumulative = cumulative_length<PxPoint>(line);
  ProjectedStroke result;
  result.dropped = projected->dropped;
  std::uint32_t hint = projected->points.front().triangle;
  for (std::size_t i = 0; i < count; ++i) {
    const PolylinePlace place = place_at(cumulative, static_cast<double>(i) / static_cast<double>(count - 1));
    const std::size_t nearer = place.segment + (place.fraction > 0.5 ? 1 : 0);
    const geometry::Ray ray = camera.ray((*even)[i]);
    if (const auto hit = surface.nearest_hit(ray, hint)) {
      hint = hit->triangle;
      result.points.push_back({hit->triangle, hit->barycentric});
      result.positions.push_back(ray.origin + ray.direction * hit->distance);
    } else {
      result.points.push_back(projected->points[nearer]);
      result.positions.push_back(projected->positions[nearer]);
    }
    result.samples.push_back(projected->samples[nearer]);
  }
  return result;
}

}  // namespace penpose::curve
