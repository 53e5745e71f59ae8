#include "core/io/gltf/write/patch/patch_joints.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "core/geometry/rotation.h"

namespace penpose::io {
namespace {

json::Json list_of(const glm::dvec3& v) { return json::Json::array({v.x, v.y, v.z}); }

}  // namespace

bool carries_the_rest(const rig::Skeleton& now, const rig::Skeleton* was) {
  const auto joints = now.joints();
  const std::size_t old = was == nullptr ? 0 : was->joints().size();
  if (joints.size() != old + 1) return false;
  const rig::Joint& added = joints.back();
  if (added.parent >= 0 || added.posable || added.translation != glm::dvec3(0) || added.scale != glm::dvec3(1) ||
      added.rest_rotation != glm::dquat(1, 0, 0, 0) || added.inverse_bind != glm::dmat4(1))
    return false;
  for (std::size_t j = 0; j < old; ++j) {
    const rig::Joint& a = joints[j];
    const rig::Joint& b = was->joints()[j];
    if (a.name != b.name || a.parent != b.parent || a.translation != b.translation || a.scale != b.scale ||
        a.rest_rotation != b.rest_rotation || a.inverse_bind != b.inverse_bind || a.posable != b.posable)
      return false;
  }
  for (std::uint32_t v = 0; v < now.vertex_count(); ++v) {
    const auto a = now.influences_of(v);
    const auto b = was == nullptr ? std::span<const rig::Influence>() : was->influences_of(v);
    if (b.empty() ? a.size() != 1 || a[0].joint != old || a[0].weight != 1.0
                  : !std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
                      return x.joint == y.joint && x.weight == y.weight;
                    }))
      return false;
  }
  return true;
}

/// A node above all parts that no joint carried. False: joints are below the same root.
bool PatchJoints::write_carrier() {
  const auto& nodes = state_.document.model.nodes;
  std::vector<std::optional<std::size_t>> parent(nodes.size());
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    for (const int child : nodes[n].children) parent[static_cast<std::size_t>(child)] = n;
  }
  std::set<std::size_t> roots;
  std::set<std::size_t> between;
  for (std::size_t p = 0; p < state_.source.parts.size(); ++p) {
    const mesh::Part& part = state_.model.mesh->parts()[p];
    if (part.vertex_count == 0) continue;
    const auto influences = state_.model.skeleton->influences_of(part.first_vertex);
    if (influences.size() != 1 || influences[0].joint != state_.source.nodes.size()) continue;
    std::size_t node = state_.source.parts[p].node;
    for (between.insert(node); parent[node]; between.insert(node)) node = *parent[node];
    roots.insert(node);
  }
  for (const auto& joint : state_.source.nodes) {
    if (!joint) continue;
    std::size_t node = *joint;
    while (parent[node]) node = *parent[node];
    if (roots.contains(node)) return false;
  }
  state_.changed = true;
  for (const std::size_t node : between) own_extras_of(state_.builder.root["nodes"][node])["carried_by_parent"] = true;
  json::Json made = {{"name", state_.model.skeleton->joints().back().name},
                     {"children", std::vector<std::size_t>(roots.begin(), roots.end())}};
  json::Json& own = own_extras_of(made);
  own["joint"] = true;
  own["posable"] = false;
  carrier_ = state_.builder.add("nodes", std::move(made));
  const std::size_t scenes = state_.builder.root.contains("scenes") ? state_.builder.root["scenes"].size() : 0;
  for (std::size_t i = 0; i < scenes; ++i) {
    const json::Json* list = json::find(state_.builder.root["scenes"][i], "nodes");
    if (list == nullptr) continue;
    json::Json left = json::Json::array();
    bool has = false;
    for (const json::Json& node : *list) {
      const bool goes = roots.contains(node.get<std::size_t>());
      if (!goes || !has) left.push_back(goes ? json::Json(*carrier_) : node);
      has = has || goes;
    }
    state_.builder.root["scenes"][i]["nodes"] = std::move(left);
  }
  return true;
}

void PatchJoints::write_pose() {
  if (!state_.model.skeleton) return;
  std::size_t parameter = state_.width();
  for (std::size_t j = 0; j < state_.model.skeleton->joints().size(); ++j) {
    const rig::Joint& joint = state_.model.skeleton->joints()[j];
    if (!joint.posable) continue;
    glm::dvec3 angles(0);
    bool posed = false;
    for (int axis = 0; axis < 3; ++axis, ++parameter) {
      angles[axis] = state_.model.pose[parameter];
      const auto was = state_.source.pose.find(state_.model.rig->parameters()[parameter].name);
      posed = posed || was == state_.source.pose.end() || was->second != angles[axis];
    }
    if (posed && state_.source.nodes[j])
      write_joint(joint, angles, state_.builder.root["nodes"][*state_.source.nodes[j]]);
  }
}

void PatchJoints::write_joint(const rig::Joint& joint, const glm::dvec3& angles, json::Json& node) {
  state_.changed = true;
  if (node.contains("matrix")) {
    node.erase("matrix");
    if (joint.translation != glm::dvec3(0)) node["translation"] = list_of(joint.translation);
    if (joint.scale != glm::dvec3(1)) node["scale"] = list_of(joint.scale);
  }
  glm::dquat rotation = joint.rest_rotation;
  if (angles != glm::dvec3(0)) rotation = rotation * geometry::quaternion_from_xyz(angles);
  const double length = std::sqrt(glm::dot(rotation, rotation));
  if (std::abs(length - 1.0) > 1e-12) rotation = rotation / length;
  node["rotation"] = json::Json::array({rotation.x, rotation.y, rotation.z, rotation.w});
  json::Json& own = own_extras_of(node);
  own["values"] = list_of(angles);
  const glm::dquat& rest = joint.rest_rotation;
  own["rest_rotation"] = json::Json::array({rest.x, rest.y, rest.z, rest.w});
}

}  // namespace penpose::io
