#include "ui/render/view.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

namespace penpose::render {

View make_view(std::span<const glm::vec3> positions, const geometry::Camera& camera) {
  geometry::Box box;
  glm::vec3 low{std::numeric_limits<float>::max()};
  glm::vec3 high{std::numeric_limits<float>::lowest()};
  for (const glm::vec3& p : positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  if (!positions.empty()) {
    box.add(geometry::ModelPoint(low));
    box.add(geometry::ModelPoint(high));
  } else {
    box.add(geometry::ModelPoint(0));
  }
  const double diagonal = box.diagonal() > 0 ? box.diagonal() : geometry::distance(camera.eye(), box.center());
  View view;
  view.middle = glm::vec3(box.center());
  view.scale = static_cast<float>(diagonal > 0 ? 1.0 / diagonal : 1.0);
  const double scale = static_cast<double>(view.scale);
  const auto scaled = [&](const geometry::ModelPoint& p) { return (p - geometry::ModelPoint(view.middle)) * scale; };
  const glm::dvec3 eye = scaled(camera.eye());
  glm::dmat4 to_view(1);
  for (int i = 0; i < 3; ++i) {
    to_view[i][0] = camera.right()[i];
    to_view[i][1] = camera.up()[i];
    to_view[i][2] = -camera.forward()[i];
  }
  to_view[3] = to_view * glm::dvec4(-eye, 1.0);
  view.to_view = glm::mat4(to_view);
  // The planes hug a sphere around the box, so that 24 bits of depth are spent on the model.
  const double middle_depth = -to_view[3][2];
  const double far = std::max(middle_depth + 0.51, 0.02);
  const double near = std::max(middle_depth - 0.51, far * 1e-3);
  const double half_height = camera.units_per_px(1.0) * camera.viewport().height * 0.5;
  const double half_width = half_height * camera.viewport().width / camera.viewport().height;
  glm::dmat4 to_clip(0);
  to_clip[0][0] = 1.0 / half_width;
  to_clip[1][1] = 1.0 / half_height;
  to_clip[2][2] = -(far + near) / (far - near);
  to_clip[2][3] = -1;
  to_clip[3][2] = -2 * far * near / (far - near);
  view.to_clip = glm::mat4(to_clip);
  view.depth_to_z = glm::vec2(1.0 / far - 1.0 / near, 1.0 / near);
  view.image_plane = glm::vec2(half_width, half_height);
  return view;
}

bool serves(const View& other, const View& view) {
  // Both models fill a sphere of diameter one in their own units; planes are 0.51 from the other's middle.
  const float moved = glm::length(view.middle - other.middle) * other.scale;
  return moved + 0.5F * other.scale / view.scale < 0.51F && view.scale < 1.02F * other.scale;
}

}  // namespace penpose::render
