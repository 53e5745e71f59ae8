#pragma once

#include <cstdint>
#include <vector>

#include "core/base/result.h"
#include "core/io/gltf/internal/gltf_extras.h"
#include "core/io/gltf/read/internal/gltf_document.h"
#include "core/io/gltf/read/internal/gltf_meshes.h"
#include "core/io/gltf/read/internal/gltf_nodes.h"
#include "core/rig/skeleton.h"

namespace penpose::io {

struct GltfSkeleton {
  std::vector<rig::Joint> joints;  ///< empty: nothing is carried by a joint
  std::vector<std::uint32_t> first_influence;
  std::vector<rig::Influence> influences;
  std::vector<double> values;               ///< the pose, three a posable joint
  std::vector<std::int32_t> joint_of_node;  ///< -1: the node is no joint
};

/// Reads skins and rigid parts. Joints are the nodes that skins name, the nodes of rigid parts (parts without a skin
/// below a node that stands elsewhere than the origin, or is animated) and all their ancestors, parents first, else in
/// the order of the nodes. Errors: place is a JSON pointer.
[[nodiscard]] base::Result<GltfSkeleton> read_skeleton(GltfDocument& document, const NodeTree& tree,
                                                       const GltfMeshes& meshes, const std::vector<NodeExtras>& extras);

}  // namespace penpose::io
