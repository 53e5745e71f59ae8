#include <cmath>
#include <functional>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <set>

#include "core/geometry/space.h"
#include "core/io/fbx/fbx_meshes.h"

namespace penpose::io {
namespace {

constexpr double k_least_scale = 1e-7;

bool all_finite(const glm::dmat4& m) {
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) {
      if (!std::isfinite(m[i][k])) return false;
    }
  }
  return true;
}

glm::dmat4 bind_matrix_of(const FbxObject& cluster) {
  const std::vector<double> numbers = cluster.record->numbers("TransformLink");
  glm::dmat4 m(0);
  if (numbers.size() != 16) return m;
  for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = numbers[static_cast<std::size_t>(i)];
  return all_finite(m) ? m : glm::dmat4(0);
}

bool is_moved(const FbxObject& node, const FbxTakes& takes) {
  const FbxTransform still = FbxNodeTransform(node).still();
  for (const auto& [name, take] : takes) {
    if (take.moves(node.id, "Lcl Translation", still.translation) ||
        take.moves(node.id, "Lcl Rotation", still.rotation) || take.moves(node.id, "Lcl Scaling", still.scaling))
      return true;
  }
  return false;
}

/// Finds the nodes that become joints.
class Wanted {
 public:
  Wanted(const FbxScene& scene, FbxPlaces& places, const FbxTakes& takes) : scene_(scene) {
    std::set<std::int64_t> leaves;
    std::size_t meshes = 0;
    for (const FbxObject& object : scene.objects()) {
      if (object.kind == "Deformer" && object.use == "Cluster") {
        for (const FbxObject* node : scene.parts_of(object.id, "Model")) {
          bound.try_emplace(node->id, bind_matrix_of(object));
          posable.insert(node->id);
        }
      }
      if (object.kind == "Model" && object.use == "LimbNode") posable.insert(object.id);
      meshes += object.kind == "Model" && has_mesh(object) ? 1U : 0U;
    }
    for (const FbxObject& object : scene.objects()) {
      if (object.kind != "Model" || !has_mesh(object)) continue;
      // Its parent is a joint; it becomes one too if its scale does not follow the parent's.
      bool apart = false;
      std::size_t depth = 0;
      for (const FbxObject* one = &object; one != nullptr && ++depth < k_deepest_fbx_node;
           one = scene.parent_of(*one)) {
        if (posable.contains(one->id) || is_moved_node(*one, takes)) {
          leaves.insert(apart ? object.id : one->id);
          const FbxObject* above = scene.parent_of(*one);
          if (meshes > 1 && one == &object && above != nullptr && has_mesh(*above)) posable.insert(one->id);
          break;
        }
        apart = apart || places.of(*one).inherits != FbxInherits::all;
      }
    }
    leaves.insert(posable.begin(), posable.end());
    for (const std::int64_t id : leaves) {
      if (!add(id)) return;
    }
  }

  std::map<std::int64_t, glm::dmat4> bound;
  std::set<std::int64_t> posable;
  std::map<std::int64_t, std::size_t> depths;  ///< how many nodes deep each lies
  const FbxObject* refused = nullptr;          ///< a node that hangs too deep

 private:
  [[nodiscard]] bool has_mesh(const FbxObject& node) const {
    return !scene_.parts_of(node.id, "Geometry", "Mesh").empty();
  }
  bool is_moved_node(const FbxObject& node, const FbxTakes& takes) {
    const auto [at, is_new] = moved_.try_emplace(node.id, false);
    if (is_new) at->second = is_moved(node, takes);
    return at->second;
  }
  bool add(std::int64_t id) {
    std::vector<const FbxObject*> way;
    const FbxObject* node = scene_.object(id);
    for (; node != nullptr && !depths.contains(node->id); node = scene_.parent_of(*node)) {
      way.push_back(node);
      refused = node;
      if (way.size() > k_deepest_fbx_node) return false;
    }
    std::size_t depth = node != nullptr ? depths[node->id] : 0;
    if (depth + way.size() > k_deepest_fbx_node) return false;
    refused = nullptr;
    for (auto at = way.rbegin(); at != way.rend(); ++at) depths[(*at)->id] = ++depth;
    return true;
  }
  const FbxScene& scene_;
  std::map<std::int64_t, bool> moved_;
};

}  // namespace

FbxLocal fbx_joint_local(const FbxLocal& node, const FbxPlaces::Place& place, const glm::dvec3& above,
                         const glm::dvec3& source, const glm::dmat4& world) {
  FbxLocal local = node;
  if (place.inherits != FbxInherits::all) {
    local.translation *= above;
    local.scale *= source;
  }
  if (place.parent != nullptr) return local;
  const double unit = geometry::length(glm::dvec3(world[0]));
  local.translation = glm::dvec3(world * glm::dvec4(local.translation, 1.0));
  local.rotation = glm::dmat3(world) / unit * local.rotation;
  local.scale *= unit;
  if (glm::determinant(glm::dmat3(world)) < 0.0) {
    // The file is left-handed.
    local.rotation[0] = -local.rotation[0];
    local.scale.x = -local.scale.x;
  }
  return local;
}

base::Result<FbxJoints> read_fbx_joints(const FbxScene& scene, FbxPlaces& places, const FbxTakes& takes) {
  const Wanted wanted(scene, places, takes);
  if (wanted.refused != nullptr)
    return base::Error{"the nodes of the file hang below themselves, or too deep", "node " + wanted.refused->name,
                       "export it again"};
  std::set<std::int64_t> split;  ///< nodes whose scale does not go along with all below them
  for (const auto& [id, depth] : wanted.depths) {
    const FbxPlaces::Place& place = places.of(*scene.object(id));
    if (place.inherits != FbxInherits::all) split.insert(place.parent->id);
  }
  FbxJoints out;
  const glm::dmat4 world = scene.to_world();
  const auto push = [&](rig::Joint joint, const FbxLocal& local) {
    joint.translation = local.translation;
    joint.rest_rotation = fbx_turn(local.rotation);
    joint.scale = local.scale;
    // Vertices at rest lie where a scale of next to nothing is one.
    FbxLocal seen = local;
    for (int i = 0; i < 3; ++i) seen.scale[i] = std::abs(seen.scale[i]) < k_least_scale ? 1.0 : seen.scale[i];
    const glm::dmat4 above = joint.parent < 0 ? glm::dmat4(1) : out.bind[static_cast<std::size_t>(joint.parent)];
    out.bind.push_back(above * seen.matrix());
    out.joints.push_back(std::move(joint));
    return static_cast<std::uint32_t>(out.joints.size() - 1);
  };
  const std::function<FbxJoints::Pair(const FbxObject&)> add = [&](const FbxObject& node) -> FbxJoints::Pair {
    if (const auto at = out.number.find(node.id); at != out.number.end()) return at->second;
    const FbxPlaces::Place place = places.of(node);
    rig::Joint joint;
    joint.name = node.name;
    joint.posable = wanted.posable.contains(node.id);
    FbxLocal own = FbxNodeTransform(node).local();
    if (!all_finite(own.matrix())) own = {};
    glm::dvec3 above(1);
    if (place.parent != nullptr) {
      const FbxJoints::Pair parent = add(*place.parent);
      joint.parent = static_cast<std::int32_t>(place.inherits == FbxInherits::all ? parent.full : parent.turned);
      above = places.of(*place.parent).scale;
    }
    const glm::dvec3 source = place.source == nullptr ? glm::dvec3(1) : places.of(*place.source).scale;
    FbxLocal local = fbx_joint_local(own, place, above, source, world);
    FbxJoints::Pair pair;
    if (split.contains(node.id)) {
      FbxLocal scale;
      scale.scale = own.scale * (place.inherits == FbxInherits::all ? glm::dvec3(1) : source);
      own.scale = glm::dvec3(1);
      local.scale = fbx_joint_local(own, place, above, glm::dvec3(1), world).scale;
      pair.turned = push(joint, local);
      rig::Joint scaled;
      scaled.name = node.name + " scale";
      scaled.posable = false;
      scaled.parent = static_cast<std::int32_t>(pair.turned);
      pair.full = push(scaled, scale);
    } else {
      pair.turned = pair.full = push(joint, local);
    }
    out.number[node.id] = pair;
    return pair;
  };
  for (const FbxObject& object : scene.objects()) {
    if (object.kind == "Model" && wanted.depths.contains(object.id)) add(object);
  }
  for (const auto& [id, matrix] : wanted.bound) {
    const auto at = out.number.find(id);
    if (at != out.number.end() && glm::determinant(world * matrix) != 0.0) out.bind[at->second.full] = world * matrix;
  }
  for (std::size_t i = 0; i < out.joints.size(); ++i)
    out.joints[i].inverse_bind = glm::determinant(out.bind[i]) != 0.0 ? glm::inverse(out.bind[i]) : glm::dmat4(1);
  return out;
}

}  // namespace penpose::io
