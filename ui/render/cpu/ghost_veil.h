#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <span>

#include "core/geometry/camera.h"
#include "core/mesh/triangle_mesh.h"
#include "ui/render/ghosts/ghost_drawings.h"
#include "ui/render/picture/image.h"

namespace penpose::render {

/// Draws ghosts as translucent faces, each with its nearest surface alone, the farthest moments first. What lies where
/// the face is now (`now`: all vertices) is clear. Half as wide and high as the camera's picture, straight alpha; null:
/// nothing of them is seen.
[[nodiscard]] std::shared_ptr<const Image> ghost_veil(std::span<const Ghost> ghosts, const mesh::TriangleMesh& mesh,
                                                      std::span<const glm::vec3> now, const geometry::Camera& camera,
                                                      const GhostInk& ink);

/// Lays such a picture over one that is twice as wide and high.
void lay_veil(const Image& veil, Image& picture);

}  // namespace penpose::render
