#include "ui/render/cpu/triangles/screen_vertices.h"

#include <cmath>

namespace penpose::render {
namespace {

/// Farther from the picture than this, in px, coordinates are not kept.
constexpr float k_most_px = 16384.0F;

}  // namespace

glm::vec3 Raster::in_view(const glm::vec3& position) const {
  return glm::vec3(view.to_view * glm::vec4((position - view.middle) * view.scale, 1.0F));
}

glm::dvec2 Raster::px(const glm::dvec3& seen) const {
  const double depth = -seen.z;
  const double x = static_cast<double>(view.to_clip[0][0]) * seen.x / depth;
  const double y = static_cast<double>(view.to_clip[1][1]) * seen.y / depth;
  return {(x * 0.5 + 0.5) * size.width + static_cast<double>(shift.x),
          (0.5 - y * 0.5) * size.height + static_cast<double>(shift.y)};
}

void place_vertices(const Raster& raster, std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                    std::vector<ScreenVertex>& placed) {
  placed.resize(positions.size());
  const glm::mat4& m = raster.view.to_view;
  const float nearest = raster.near();
  const float half_x = static_cast<float>(raster.size.width) * 0.5F;
  const float half_y = static_cast<float>(raster.size.height) * 0.5F;
  const float scale_x = raster.view.to_clip[0][0] * half_x;
  const float scale_y = raster.view.to_clip[1][1] * half_y;
  const float middle_x = half_x + raster.shift.x;
  const float middle_y = half_y + raster.shift.y;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const glm::vec3 p = raster.in_view(positions[v]);
    const glm::vec3& n = normals[v];
    ScreenVertex& out = placed[v];
    out.normal = {m[0][0] * n.x + m[1][0] * n.y + m[2][0] * n.z, m[0][1] * n.x + m[1][1] * n.y + m[2][1] * n.z,
                  m[0][2] * n.x + m[1][2] * n.y + m[2][2] * n.z};
    const float inverse = 1.0F / -p.z;
    const float x = middle_x + scale_x * p.x * inverse;
    const float y = middle_y - scale_y * p.y * inverse;
    // Numbers that are none fail these, too.
    if (-p.z >= nearest && std::abs(x) < k_most_px && std::abs(y) < k_most_px) {
      out.corner = {static_cast<std::int32_t>(std::floor(x * k_subpixels + 0.5F)),
                    static_cast<std::int32_t>(std::floor(y * k_subpixels + 0.5F)), inverse};
    } else {
      out.corner = {k_must_be_clipped, 0, 0};
    }
  }
}

}  // namespace penpose::render
