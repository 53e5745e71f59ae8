#include "core/animation/solve/seen_points.h"

#include <utility>

namespace penpose::animation {

SeenPoints::SeenPoints(const rig::Rig& rig, std::vector<posing::CurvePoint> points, const geometry::Camera& camera)
    : camera_(camera), points_(std::move(points)) {
  std::vector<std::uint32_t> vertices;
  for (const posing::CurvePoint& point : points_) {
    vertices.insert(vertices.end(), point.vertex.begin(), point.vertex.end());
  }
  bound_ = rig.bind(vertices);
  positions_.resize(vertices.size());
}

std::vector<geometry::PxPoint> SeenPoints::at(std::span<const double> pose) {
  bound_->evaluate(pose, positions_);
  std::vector<geometry::PxPoint> places;
  places.reserve(points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i) {
    geometry::ModelPoint p(0);
    for (std::size_t k = 0; k < 3; ++k) p += positions_[3 * i + k] * points_[i].weight[k];
    places.push_back(camera_.project(p).value_or(geometry::PxPoint{}));
  }
  return places;
}

}  // namespace penpose::animation
