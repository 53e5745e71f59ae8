#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "core/document/model.h"
#include "core/geometry/placement.h"
#include "ui/render/scene.h"

namespace penpose::render {

/// One of several models that are drawn together.
struct ScenePart {
  const document::Model* model = nullptr;
  const Appearance* appearance = nullptr;  ///< of the model
  geometry::Placement placement;
  std::span<const glm::vec3> positions = {};  ///< one a vertex of the model
  std::span<const glm::vec3> normals = {};
};

/// Triangles and looks of several models as those of one: vertices and triangles of each follow those of the one
/// before.
struct MergedShape {
  std::vector<mesh::Triangle> triangles;
  Appearance appearance;
};
/// Reads models and appearances. Precondition: at least one part.
[[nodiscard]] MergedShape merged_shape(std::span<const ScenePart> parts);

/// Positions and normals of several models in their places, in the order of their vertices.
struct MergedPose {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
};
[[nodiscard]] MergedPose merged_pose(std::span<const ScenePart> parts);

}  // namespace penpose::render
