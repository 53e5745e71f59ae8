#include "core/intent/line/view_rows.h"

#include <glm/geometric.hpp>

namespace penpose::intent {

std::optional<ViewDerivative> view_derivative(const geometry::Camera& camera, const geometry::ModelPoint& at) {
  const double depth = camera.depth(at);
  if (!(depth > 0.0)) return std::nullopt;
  const geometry::ModelVector from = at - camera.eye();
  const double px = 1.0 / camera.units_per_px(depth);
  // d/dp of focal * (from . right) / (from . forward), and likewise downwards.
  ViewDerivative d;
  d.x = (camera.right() - camera.forward() * (glm::dot(from, camera.right()) / depth)) * px;
  d.y = (camera.up() - camera.forward() * (glm::dot(from, camera.up()) / depth)) * -px;
  d.ray = geometry::normalized(from) * px;
  return d;
}

}  // namespace penpose::intent
