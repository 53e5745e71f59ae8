#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <vector>

#include "core/geometry/camera.h"
#include "ui/render/view.h"

namespace penpose::render {

/// Steps of a px in which corners of triangles are placed.
inline constexpr std::int32_t k_subpixels = 256;
/// In place of a coordinate: the vertex is nearer than the near plane, or too far aside for whole numbers.
inline constexpr std::int32_t k_must_be_clipped = std::numeric_limits<std::int32_t>::min();

/// Where a corner is seen: px from the upper left in steps of 1 / k_subpixels.
struct Corner {
  std::int32_t x = 0;
  std::int32_t y = 0;
  float inverse_depth = 0;  ///< 1 / distance along the view, in the units of View; larger is nearer
};

/// A vertex as a view sees it.
struct ScreenVertex {
  Corner corner;
  glm::vec3 normal{0};  ///< in the camera's space
};

/// How px of a picture and the camera's space belong together. `shift` moves the picture by parts of a px.
struct Raster {
  View view;
  geometry::Viewport size;
  glm::vec2 shift{0, 0};

  [[nodiscard]] glm::vec3 in_view(const glm::vec3& position) const;
  /// Distance of the near plane.
  [[nodiscard]] float near() const { return view.to_clip[3][2] / (view.to_clip[2][2] - 1.0F); }
  /// Px of a point of the camera's space before the near plane, not rounded.
  [[nodiscard]] glm::dvec2 px(const glm::dvec3& seen) const;
};

void place_vertices(const Raster& raster, std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                    std::vector<ScreenVertex>& placed);

}  // namespace penpose::render
