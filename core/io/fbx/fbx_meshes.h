#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <map>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/document/model.h"
#include "core/io/fbx/fbx_scene.h"
#include "core/mesh/triangle_mesh.h"

namespace penpose::io {

/// The tree of nodes that carry vertices.
struct FbxJoints {
  std::vector<rig::Joint> joints;
  std::map<std::int64_t, std::uint32_t> number;  ///< of a node's id
  std::vector<glm::dmat4> bind;                  ///< of each joint in the world when it was bound
  std::vector<glm::dmat4> now;                   ///< and as the file shows it
};

/// Everything of the file's meshes, in the world: +y up, metres.
struct FbxMeshes {
  mesh::MeshSource source;
  std::vector<document::Material> materials;            ///< one a part
  std::vector<std::vector<rig::Influence>> influences;  ///< one a vertex; empty without joints
  std::vector<rig::BlendShape> shapes;
  std::vector<double> values;  ///< of the shapes
};

/// Errors: nodes that hang below themselves or more than 1,000 deep.
[[nodiscard]] base::Result<FbxJoints> read_fbx_joints(const FbxScene& scene);
/// A vertex is a control point of its mesh, in the file's order; polygons are cut into triangles. A shape between
/// others (FullWeights) is a control of its own that adds what it has more than its share of the full one. Errors: no
/// meshes, a corner that is no vertex, more than 16 million vertices.
[[nodiscard]] base::Result<FbxMeshes> read_fbx_meshes(const FbxScene& scene, const FbxJoints& joints,
                                                      std::vector<std::string>& notes);

}  // namespace penpose::io
