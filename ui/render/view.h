#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "core/geometry/camera.h"

namespace penpose::render {

/// Where the model lies and how the camera sees it, in numbers of moderate size whatever the model's units: the middle
/// of the box is moved to the origin and its diagonal scaled to one.
struct View {
  glm::vec3 middle{0};
  float scale = 1;
  glm::mat4 to_view{1};
  glm::mat4 to_clip{1};
  glm::vec2 depth_to_z{1, 0};   ///< z = 1 / (x * depth + y), in scaled units
  glm::vec2 image_plane{1, 1};  ///< half width and half height at distance 1
  friend bool operator==(const View&, const View&) = default;
};
/// Whether a view of another pose, by the same camera, serves for the model that `view` was made for: it lies between
/// its planes.
[[nodiscard]] bool serves(const View& other, const View& view);
[[nodiscard]] View make_view(std::span<const glm::vec3> positions, const geometry::Camera& camera);

}  // namespace penpose::render
