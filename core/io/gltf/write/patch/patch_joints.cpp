#include "core/io/gltf/write/patch/patch_joints.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <vector>

#include "core/geometry/rotation.h"
#include "core/io/gltf/vrm/vrm_extension.h"

namespace penpose::io {
namespace {

json::Json list_of(const glm::dvec3& v) { return json::Json::array({v.x, v.y, v.z}); }
json::Json list_of(const glm::dquat& q) { return json::Json::array({q.x, q.y, q.z, q.w}); }

}  // namespace

PatchJoints::PatchJoints(PatchState& state) : state_(state), stay_at_rest_(is_vrm_avatar(state.document.json)) {}

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

void PatchJoints::write_carrier() {
  const auto& nodes = state_.document.model.nodes;
  std::vector<std::optional<std::size_t>> parent(nodes.size());
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    for (const int child : nodes[n].children) parent[static_cast<std::size_t>(child)] = n;
  }
  const auto root_of = [&](std::size_t node) {
    while (parent[node]) node = *parent[node];
    return node;
  };
  std::set<std::size_t> of_joints;
  for (const auto& joint : state_.source.nodes) {
    if (joint) of_joints.insert(root_of(*joint));
  }
  state_.changed = true;
  std::set<std::size_t> below;
  for (MeshTargets& mesh : state_.targets.meshes()) {
    const bool carried = std::any_of(mesh.parts.begin(), mesh.parts.end(), [&](std::size_t p) {
      const mesh::Part& part = state_.model.mesh->parts()[p];
      if (part.vertex_count == 0) return false;
      const auto influences = state_.model.skeleton->influences_of(part.first_vertex);
      return influences.size() == 1 && influences[0].joint == state_.source.nodes.size();
    });
    if (!carried) continue;
    const std::size_t root = root_of(mesh.node);
    if (of_joints.contains(root)) {
      carry_alone(mesh, parent[mesh.node]);
      below.insert(mesh.node);
      continue;
    }
    below.insert(root);
    for (std::optional<std::size_t> node = mesh.node; node; node = parent[*node]) {
      own_extras_of(state_.builder.root["nodes"][*node])["carried_by_parent"] = true;
    }
  }
  json::Json made = {{"name", state_.model.skeleton->joints().back().name},
                     {"children", std::vector<std::size_t>(below.begin(), below.end())}};
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
      const bool goes = below.contains(node.get<std::size_t>());
      if (!goes || !has) left.push_back(goes ? json::Json(*carrier_) : node);
      has = has || goes;
    }
    const bool shows = std::any_of(list->begin(), list->end(),
                                   [&](const json::Json& node) { return of_joints.contains(node.get<std::size_t>()); });
    if (!has && shows) left.push_back(*carrier_);
    state_.builder.root["scenes"][i]["nodes"] = std::move(left);
  }
}

/// Takes a mesh out of a tree with joints. Nothing above it moves it at rest, or a joint would carry it; so it stands
/// below the carrier where it stood. A node that others hang on, or that is a joint, stays and gives its mesh away.
void PatchJoints::carry_alone(MeshTargets& mesh, std::optional<std::size_t> parent) {
  json::Json& nodes = state_.builder.root["nodes"];
  const std::size_t old = mesh.node;
  const json::Json* children = json::find(nodes[old], "children");
  const auto& joints = state_.source.nodes;
  const bool stays = (children != nullptr && !children->empty()) ||
                     std::find(joints.begin(), joints.end(), std::optional(old)) != joints.end();
  if (!stays && parent) {
    json::Json left = json::Json::array();
    for (const json::Json& child : nodes[*parent]["children"]) {
      if (child.get<std::size_t>() != old) left.push_back(child);
    }
    if (left.empty()) {
      nodes[*parent].erase("children");
    } else {
      nodes[*parent]["children"] = std::move(left);
    }
    own_extras_of(nodes[old])["carried_by_parent"] = true;
    return;
  }
  json::Json made = json::Json::object();
  for (const char* name : {"name", "mesh", "weights", "skin"}) {
    const json::Json* has = json::find(nodes[old], name);
    if (has == nullptr) continue;
    made[name] = *has;
    if (std::string_view(name) != "name") nodes[old].erase(name);
  }
  own_extras_of(made)["carried_by_parent"] = true;
  // Nodes below a mesh can be posed (read_skeleton).
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const rig::Joint& joint = state_.model.skeleton->joints()[j];
    const bool below = joint.parent >= 0 && joints[j] && joints[static_cast<std::size_t>(joint.parent)] == old;
    if (below) own_extras_of(nodes[*joints[j]])["posable"] = joint.posable;
  }
  mesh.node = state_.builder.add("nodes", std::move(made));
  const std::size_t animations =
      state_.builder.root.contains("animations") ? state_.builder.root["animations"].size() : 0;
  for (std::size_t a = 0; a < animations; ++a) {
    json::Json& channels = state_.builder.root["animations"][a]["channels"];
    for (std::size_t c = 0; c < channels.size(); ++c) {
      if (moves_weights_of(channels[c], old)) channels[c]["target"]["node"] = mesh.node;
    }
  }
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
    apart_ = apart_ || (stay_at_rest_ && angles != glm::dvec3(0));
    if (posed && state_.source.nodes[j])
      write_joint(joint, angles, state_.builder.root["nodes"][*state_.source.nodes[j]]);
  }
  if (stay_at_rest_ && state_.changed) put_to_rest();
}

/// Nodes that were saved with their pose.
void PatchJoints::put_to_rest() {
  for (std::size_t j = 0; j < state_.source.nodes.size(); ++j) {
    if (!state_.source.nodes[j]) continue;
    json::Json& node = state_.builder.root["nodes"][*state_.source.nodes[j]];
    const glm::dquat& rest = state_.model.skeleton->joints()[j].rest_rotation;
    const auto& read = state_.document.model.nodes[*state_.source.nodes[j]];
    if (!read.matrix.empty()) continue;
    const bool turned = read.rotation.size() == 4;
    const glm::dquat is = turned ? glm::dquat(read.rotation[3], read.rotation[0], read.rotation[1], read.rotation[2])
                                 : glm::dquat(1, 0, 0, 0);
    if (is != rest) node["rotation"] = list_of(rest);
  }
}

void PatchJoints::write_joint(const rig::Joint& joint, const glm::dvec3& angles, json::Json& node) {
  state_.changed = true;
  json::Json& own = own_extras_of(node);
  own["values"] = list_of(angles);
  own["rest_rotation"] = list_of(joint.rest_rotation);
  if (stay_at_rest_) return;
  if (node.contains("matrix")) {
    node.erase("matrix");
    if (joint.translation != glm::dvec3(0)) node["translation"] = list_of(joint.translation);
    if (joint.scale != glm::dvec3(1)) node["scale"] = list_of(joint.scale);
  }
  glm::dquat rotation = joint.rest_rotation;
  if (angles != glm::dvec3(0)) rotation = rotation * geometry::quaternion_from_xyz(angles);
  const double length = std::sqrt(glm::dot(rotation, rotation));
  if (std::abs(length - 1.0) > 1e-12) rotation = rotation / length;
  node["rotation"] = list_of(rotation);
}

}  // namespace penpose::io
