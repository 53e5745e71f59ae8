#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>

#include "core/geometry/camera.h"
#include "core/mesh/triangle_mesh.h"
#include "ui/render/cpu/cpu_renderer.h"
#include "ui/render/ghosts/ghost_drawings.h"
#include "ui/render/picture/image.h"

namespace penpose::render {

/// The model whose ghosts are drawn.
struct VeiledModel {
  const mesh::TriangleMesh& mesh;
  const Appearance& appearance;
  std::uint64_t shape_number = 0;       ///< as Scene
  std::span<const glm::vec3> now = {};  ///< all vertices of the face as it is now
};

/// Draws ghosts as translucent faces: as the model looks, tinted, each with its nearest surface alone, the farthest
/// moments first. Keeps what drawing takes from one veil to the next.
class GhostVeil {
 public:
  GhostVeil();
  /// What lies where the face is now is clear. Half as wide and high as the camera's picture, straight alpha; null:
  /// nothing of ghosts is seen.
  [[nodiscard]] std::shared_ptr<const Image> draw(std::span<const Ghost> ghosts, const VeiledModel& model,
                                                  const geometry::Camera& camera, const GhostInk& ink);

 private:
  CpuRenderer renderer_;
  Image face_;
};

/// Lays such a picture over one that is twice as wide and high.
void lay_veil(const Image& veil, Image& picture);

}  // namespace penpose::render
