#include "tests/judges/cases/picture.h"

#include <glm/geometric.hpp>

#include "core/base/math.h"

namespace penpose::judges {

std::vector<ModelPoint> posed(const document::Model& model, const rig::Pose& pose) {
  std::vector<ModelPoint> places(model.mesh->vertex_count());
  model.rig->evaluate(pose, places);
  return places;
}

double size_of(std::span<const ModelPoint> places, std::span<const FaceLine> lines) {
  geometry::Box box;
  for (const FaceLine& line : lines) {
    for (const std::uint32_t v : line.vertices) box.add(places[v]);
  }
  return box.diagonal();
}

Picture::Picture(double yaw_degrees, double size)
    : right_(base::cos(base::radians(yaw_degrees)), 0, -base::sin(base::radians(yaw_degrees))),
      back_(base::sin(base::radians(yaw_degrees)), 0, base::cos(base::radians(yaw_degrees))),
      px_(k_face_px / size) {}

PxPoint Picture::flat(const ModelPoint& p) const { return {glm::dot(p, right_) * px_, p.y * px_}; }

std::vector<PxPoint> Picture::flat(std::span<const ModelPoint> places, std::span<const std::uint32_t> vertices) const {
  std::vector<PxPoint> line;
  for (const std::uint32_t v : vertices) line.push_back(flat(places[v]));
  return line;
}

std::vector<ModelPoint> Picture::in_space(std::span<const PxPoint> line, std::span<const ModelPoint> places,
                                          std::span<const std::uint32_t> vertices) const {
  double depth = 0;
  for (const std::uint32_t v : vertices) depth += glm::dot(places[v], back_) / static_cast<double>(vertices.size());
  std::vector<ModelPoint> out;
  for (const PxPoint& p : line) out.push_back(right_ * (p.x / px_) + ModelPoint{0, p.y / px_, 0} + back_ * depth);
  return out;
}

}  // namespace penpose::judges
