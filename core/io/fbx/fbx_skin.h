#pragma once

#include <cstdint>
#include <vector>

#include "core/io/fbx/fbx_meshes.h"

namespace penpose::io {

/// How one mesh follows joints.
struct FbxSkin {
  glm::dmat4 placed{1};                                 ///< from the mesh to its vertices at rest
  glm::dmat4 placed_loose{1};                           ///< the same for vertices that no joint of its skin takes along
  std::vector<std::vector<rig::Influence>> influences;  ///< one a vertex; empty where it follows none
  std::vector<bool> loose;                              ///< one a vertex where it has a skin, else empty
  std::size_t looked_at = 0;                            ///< numbers
};

/// `points`: three numbers a vertex. A joint to which meshes were bound in several ways gets one more below it for each
/// of them. What no skin takes along follows the nearest joint above it, or stays where the file shows it.
[[nodiscard]] FbxSkin read_fbx_skin(const FbxScene& scene, const FbxObject& node, const FbxObject& geometry,
                                    const std::vector<double>& points, FbxPlaces& places, FbxJoints& joints);

}  // namespace penpose::io
