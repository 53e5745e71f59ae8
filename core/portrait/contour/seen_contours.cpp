#include "core/portrait/contour/seen_contours.h"

#include <algorithm>
#include <utility>

namespace penpose::portrait {
namespace {

/// Folds of a mouth or an ear make many short ones: a share of the picture's height.
constexpr double k_least_contour = 0.01;

std::vector<geometry::ModelPoint> places_at_rest(const rig::Rig& rig) {
  std::vector<geometry::ModelPoint> out(rig.vertex_count());
  rig.evaluate(rig::rest_pose(rig), out);
  return out;
}

}  // namespace

SeenContours::SeenContours(const rig::Rig& rig, const mesh::TriangleMesh& mesh, const geometry::Camera& camera)
    : rig_(rig),
      mesh_(mesh),
      camera_(camera),
      positions_(places_at_rest(rig)),
      floats_(positions_.begin(), positions_.end()),
      tree_(floats_, mesh.triangles(), geometry::TriangleBvh::Build::quick) {}

void SeenContours::look(const rig::Pose& pose) {
  rig_.evaluate(pose, positions_);
  std::copy(positions_.begin(), positions_.end(), floats_.begin());
  tree_.refit(floats_);
  lines_.clear();
  const double least = k_least_contour * camera_.viewport().height;
  for (SurfaceLine& line : silhouette(camera_, mesh_, positions_, tree_, least)) {
    SeenContour seen;
    for (const posing::CurvePoint& point : line) {
      const PxPoint at = camera_.project(place_of(point, positions_)).value_or(PxPoint{});
      seen.lengths.push_back(seen.px.empty() ? 0.0 : seen.lengths.back() + geometry::distance(seen.px.back(), at));
      seen.px.push_back(at);
    }
    if (seen.lengths.back() < least) break;
    for (std::size_t i = 0; i + 1 < seen.px.size(); ++i) {
      if (i % k_boxed == 0) seen.boxes.emplace_back();
      seen.boxes.back().add(seen.px[i]);
      seen.boxes.back().add(seen.px[i + 1]);
    }
    seen.closed =
        line.size() > 2 && line.front().vertex == line.back().vertex && line.front().weight == line.back().weight;
    seen.points = std::move(line);
    lines_.push_back(std::move(seen));
  }
}

PxBox SeenContours::box() const {
  PxBox box;
  for (const SeenContour& line : lines_) {
    for (const PxPoint& p : line.px) box.add(p);
  }
  return box;
}

}  // namespace penpose::portrait
