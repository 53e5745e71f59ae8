#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/io/gltf/read/internal/gltf_document.h"

namespace penpose::io {

/// Where a node stands in its parent: translation * rotation * scale. The rotation may not be of length one, but is not
/// zero.
struct NodeTransform {
  glm::dvec3 translation{0};
  glm::dquat rotation{1, 0, 0, 0};
  glm::dvec3 scale{1};
  bool sheared = false;  ///< the matrix sheared, and this is the nearest transform that does not
  friend bool operator==(const NodeTransform&, const NodeTransform&) = default;
};

/// The transform of a node. A matrix is taken apart, with the nearest rotation where its axes stand in no right angles;
/// a rotation of length zero turns nothing. Errors (place: JSON pointer): a matrix that is no transform of space, a
/// number too large to calculate with.
[[nodiscard]] base::Result<NodeTransform> node_transform(const GltfDocument& document, std::size_t node);

/// How the nodes of a document hang together.
struct NodeTree {
  std::vector<std::int32_t> parent;  ///< -1: a root
  std::vector<bool> in_scene;        ///< below a node of the default scene; all when the file has no scene
};
[[nodiscard]] NodeTree make_node_tree(const GltfDocument& document);

/// Joins with the JSON pointer "/nodes/N".
[[nodiscard]] std::string node_pointer(std::size_t node);

}  // namespace penpose::io
