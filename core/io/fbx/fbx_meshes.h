#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/document/model.h"
#include "core/io/fbx/fbx_places.h"
#include "core/io/fbx/fbx_scene.h"
#include "core/io/fbx/fbx_shapes.h"
#include "core/io/fbx/motion/fbx_take.h"
#include "core/mesh/triangle_mesh.h"

namespace penpose::io {

using FbxTakes = std::vector<std::pair<std::string, FbxTake>>;

/// The tree of nodes that carry vertices.
struct FbxJoints {
  struct Pair {
    std::uint32_t turned = 0;  ///< the joint that has the node's translation and rotation
    std::uint32_t full = 0;    ///< the joint that has its scale as well; mostly the same
  };
  std::vector<rig::Joint> joints;
  std::map<std::int64_t, Pair> number;  ///< of a node's id
  std::vector<glm::dmat4> bind;         ///< of each joint in the world, where the vertices at rest are
  std::map<std::uint32_t, std::vector<std::uint32_t>> more;  ///< below a joint: the same, bound otherwise
};

/// Everything of the file's meshes, in the world: +y up, metres.
struct FbxMeshes {
  mesh::MeshSource source;
  std::vector<document::Material> materials;            ///< one a part
  std::vector<std::vector<rig::Influence>> influences;  ///< one a vertex; empty without joints
  std::vector<rig::BlendShape> shapes;
  std::vector<double> values;        ///< of the shapes
  std::vector<FbxChannel> channels;  ///< which drive the shapes
};

/// Nodes that a skin binds to, that are drawn as bones, or that keys move along with a mesh, and all above them. A node
/// whose scale does not go along with all below it has two joints. Errors: nodes that hang below themselves or more
/// than 1,000 deep.
[[nodiscard]] base::Result<FbxJoints> read_fbx_joints(const FbxScene& scene, FbxPlaces& places, const FbxTakes& takes);
/// The joint's transform, of values of its node and of the scales that it takes; `world` for those without a parent.
[[nodiscard]] FbxLocal fbx_joint_local(const FbxLocal& node, const FbxPlaces::Place& place, const glm::dvec3& above,
                                       const glm::dvec3& source, const glm::dmat4& world);

/// A vertex is a control point of its mesh, in the file's order; polygons are cut into triangles. Joints are added
/// where meshes were bound to one in several ways. Errors: no meshes, a corner that is no vertex, more than 16 million
/// vertices.
[[nodiscard]] base::Result<FbxMeshes> read_fbx_meshes(const FbxScene& scene, FbxPlaces& places, FbxJoints& joints,
                                                      std::vector<std::string>& notes);

}  // namespace penpose::io
