#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/document/model.h"
#include "core/io/gltf/read/internal/gltf_document.h"
#include "core/io/gltf/read/internal/gltf_nodes.h"
#include "core/mesh/triangle_mesh.h"

namespace penpose::io {

/// Where a part comes from: the primitives of one mesh that share their vertices, under one node.
struct PartOrigin {
  std::size_t node = 0;
  std::size_t mesh = 0;
  std::vector<std::size_t> primitives;  ///< the first one stands for all attributes

  [[nodiscard]] const tinygltf::Primitive& primitive(const GltfDocument& document) const {
    return document.model.meshes[mesh].primitives[primitives.front()];
  }
  /// "/meshes/M/primitives/P" of the first primitive.
  [[nodiscard]] std::string pointer() const;
};

/// The mesh in whose place the parts of a mesh stand: the one that it is a copy of (gltf_extras.h), or itself.
[[nodiscard]] std::size_t place_of_mesh(const GltfDocument& document, std::size_t mesh);

struct GltfMeshes {
  std::vector<PartOrigin> origins;  ///< one a part
  mesh::MeshSource source;
  std::vector<document::Material> materials;  ///< one a part
};

/// Gathers the triangles of all meshes in the scene, in the order of the meshes, then of the nodes that use them.
/// Strips and fans become triangles; points and lines are left out and noted.
/// Errors: place is a JSON pointer.
[[nodiscard]] base::Result<GltfMeshes> read_meshes(GltfDocument& document, const NodeTree& tree);

}  // namespace penpose::io
