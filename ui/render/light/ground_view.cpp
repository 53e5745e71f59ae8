#include "ui/render/light/ground_view.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

namespace penpose::render {

std::optional<GroundView> view_of_ground(const BakedLight& light, const View& view, geometry::Viewport size) {
  if (!(light.half_side > 0) || light.ground_shade.empty()) return std::nullopt;
  GroundView seen;
  const glm::vec3 eye = -(glm::transpose(glm::mat3(view.to_view)) * glm::vec3(view.to_view[3]));
  seen.eye = (eye / view.scale + view.middle - light.ground) / light.half_side;
  if (!(seen.eye.y > 0)) return std::nullopt;
  seen.right = size.width;
  seen.bottom = size.height;
  glm::vec2 low(1);
  glm::vec2 high(-1);
  for (const glm::vec2 side : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(-1, 1), glm::vec2(1, 1)}) {
    const glm::vec3 corner = light.ground + light.half_side * glm::vec3(side.x, 0, side.y);
    const glm::vec4 p = view.to_view * glm::vec4((corner - view.middle) * view.scale, 1);
    if (p.z > -1e-3F) return seen;  // around the eye: anywhere
    const glm::vec2 at(p.x / -p.z / view.image_plane.x, p.y / -p.z / view.image_plane.y);
    low = glm::min(low, at);
    high = glm::max(high, at);
  }
  const auto px = [](float share, int side) {
    return static_cast<int>(
        std::clamp((share * 0.5F + 0.5F) * static_cast<float>(side), 0.0F, static_cast<float>(side)));
  };
  seen.left = px(low.x, size.width);
  seen.right = std::min(px(high.x, size.width) + 1, size.width);
  seen.top = px(-high.y, size.height);
  seen.bottom = std::min(px(-low.y, size.height) + 1, size.height);
  if (seen.left >= seen.right || seen.top >= seen.bottom) return std::nullopt;
  return seen;
}

}  // namespace penpose::render
