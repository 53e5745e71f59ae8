#include <cmath>
#include <functional>
#include <glm/matrix.hpp>
#include <set>

#include "core/io/fbx/fbx_meshes.h"

namespace penpose::io {
namespace {

bool all_finite(const glm::dmat4& m) {
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) {
      if (!std::isfinite(m[i][k])) return false;
    }
  }
  return true;
}

glm::dmat4 matrix_of(const FbxObject& object, const char* name) {
  const std::vector<double> numbers = object.record->numbers(name);
  glm::dmat4 m(1);
  if (numbers.size() != 16) return m;
  for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = numbers[static_cast<std::size_t>(i)];
  return all_finite(m) ? m : glm::dmat4(1);
}

}  // namespace

base::Result<FbxJoints> read_fbx_joints(const FbxScene& scene) {
  // Nodes that carry vertices or are drawn as bones, and all above them.
  std::map<std::int64_t, glm::dmat4> bound;
  std::set<std::int64_t> posable;
  std::map<std::int64_t, std::size_t> wanted;  ///< how many nodes deep each lies
  for (const FbxObject& object : scene.objects()) {
    if (object.kind == "Deformer" && object.use == "Cluster") {
      for (const FbxObject* node : scene.parts_of(object.id, "Model")) {
        bound.try_emplace(node->id, matrix_of(object, "TransformLink"));
        posable.insert(node->id);
      }
    }
    if (object.kind == "Model" && object.use == "LimbNode") posable.insert(object.id);
  }
  for (const std::int64_t id : posable) {
    std::vector<const FbxObject*> way;
    const auto refused = [&] {
      return base::Error{"the nodes of the file hang below themselves, or too deep", "node " + way.back()->name,
                         "export it again"};
    };
    const FbxObject* node = scene.object(id);
    for (; node != nullptr && !wanted.contains(node->id); node = scene.parent_of(*node)) {
      way.push_back(node);
      if (way.size() > k_deepest_fbx_node) return refused();
    }
    std::size_t depth = node != nullptr ? wanted[node->id] : 0;
    if (depth + way.size() > k_deepest_fbx_node) return refused();
    for (auto at = way.rbegin(); at != way.rend(); ++at) wanted[(*at)->id] = ++depth;
  }
  FbxJoints out;
  const glm::dmat4 world = scene.to_world();
  const std::function<std::uint32_t(const FbxObject&)> add = [&](const FbxObject& node) -> std::uint32_t {
    if (const auto at = out.number.find(node.id); at != out.number.end()) return at->second;
    rig::Joint joint;
    joint.name = node.name;
    joint.posable = posable.contains(node.id);
    glm::dmat4 local = local_matrix(node, transform_of(node));
    if (!all_finite(local)) local = glm::dmat4(1);
    const FbxObject* above = scene.parent_of(node);
    glm::dmat4 now = local;
    if (above != nullptr) {
      const std::uint32_t parent = add(*above);
      joint.parent = static_cast<std::int32_t>(parent);
      now = out.now[parent] * local;
    } else {
      now = local = world * local;
    }
    const FbxLocal parts = parts_of(local);
    joint.translation = parts.translation;
    joint.rest_rotation = parts.rotation;
    joint.scale = parts.scale;
    const auto at = bound.find(node.id);
    const glm::dmat4 bind = at != bound.end() ? world * at->second : now;
    joint.inverse_bind = glm::determinant(bind) != 0.0 ? glm::inverse(bind) : glm::dmat4(1);
    const auto number = static_cast<std::uint32_t>(out.joints.size());
    out.number[node.id] = number;
    out.joints.push_back(std::move(joint));
    out.now.push_back(now);
    out.bind.push_back(bind);
    return number;
  };
  for (const FbxObject& object : scene.objects()) {
    if (object.kind == "Model" && wanted.contains(object.id)) add(object);
  }
  return out;
}

}  // namespace penpose::io
