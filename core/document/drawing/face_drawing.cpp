#include "core/document/drawing/face_drawing.h"

#include <glm/geometric.hpp>

namespace penpose::document {

bool same_side(const View& a, const View& b) {
  constexpr double k_cosine = 0.97;  // 14 degrees
  const geometry::ModelVector one = a.camera.look_at - a.camera.eye, other = b.camera.look_at - b.camera.eye;
  return glm::dot(one, other) > k_cosine * geometry::length(one) * geometry::length(other);
}

std::optional<std::vector<geometry::ModelPoint>> points_of(const View& view, const std::vector<curve::PxPoint>& line,
                                                           const geometry::ModelPoint& middle) {
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  if (!camera) return std::nullopt;
  const double depth = camera->depth(middle);
  std::vector<geometry::ModelPoint> out;
  for (const curve::PxPoint& p : line) {
    const geometry::Ray ray = camera->ray(p);
    const double ahead = glm::dot(ray.direction, camera->forward());
    if (!(ahead > 0.0 && depth > 0.0)) return std::nullopt;
    out.push_back(ray.origin + ray.direction * (depth / ahead));
  }
  return out;
}

std::optional<std::vector<curve::PxPoint>> line_in(const View& to, const View& from,
                                                   const std::vector<curve::PxPoint>& line,
                                                   const geometry::ModelPoint& middle) {
  if (to == from) return line;
  const auto seen = geometry::Camera::make(to.camera, to.viewport);
  const auto points = seen && same_side(to, from) ? points_of(from, line, middle) : std::nullopt;
  if (!points) return std::nullopt;
  std::vector<curve::PxPoint> out;
  for (const geometry::ModelPoint& point : *points) {
    const auto px = seen->project(point);
    if (!px) return std::nullopt;
    out.push_back(*px);
  }
  return out;
}

}  // namespace penpose::document
