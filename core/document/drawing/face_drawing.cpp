#include "core/document/drawing/face_drawing.h"

#include <glm/geometric.hpp>

namespace penpose::document {

bool same_side(const View& a, const View& b) {
  constexpr double k_cosine = 0.97;  // 14 degrees
  const geometry::ModelVector one = a.camera.look_at - a.camera.eye, other = b.camera.look_at - b.camera.eye;
  return glm::dot(one, other) > k_cosine * geometry::length(one) * geometry::length(other);
}

std::optional<std::vector<curve::PxPoint>> line_in(const View& to, const View& from,
                                                   const std::vector<curve::PxPoint>& line,
                                                   const geometry::ModelPoint& middle) {
  if (to == from) return line;
  if (!same_side(to, from)) return std::nullopt;
  const auto drawn = geometry::Camera::make(from.camera, from.viewport);
  const auto seen = geometry::Camera::make(to.camera, to.viewport);
  if (!drawn || !seen) return std::nullopt;
  std::vector<curve::PxPoint> out;
  for (const curve::PxPoint& p : line) {
    // On the plane through the middle that faces the eye.
    const geometry::Ray ray = drawn->ray(p);
    const double ahead = glm::dot(ray.direction, drawn->forward());
    const double depth = drawn->depth(middle);
    if (!(ahead > 0.0 && depth > 0.0)) return std::nullopt;
    const auto px = seen->project(ray.origin + ray.direction * (depth / ahead));
    if (!px) return std::nullopt;
    out.push_back(*px);
  }
  return out;
}

}  // namespace penpose::document
