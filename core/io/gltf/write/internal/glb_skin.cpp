#include "core/io/gltf/write/internal/glb_skin.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <string>

#include "core/geometry/rotation.h"
#include "core/io/gltf/internal/gltf_extras.h"

namespace penpose::io {
namespace {

constexpr std::size_t k_no_skin = static_cast<std::size_t>(-1);

json::Json vector_json(const glm::dvec3& v) { return json::Json::array({v.x, v.y, v.z}); }
json::Json numbers_of(const glm::dmat4& m) { return std::vector<double>(&m[0][0], &m[0][0] + 16); }
json::Json vector_json(const glm::dquat& q) { return json::Json::array({q.x, q.y, q.z, q.w}); }

void add_bind(const glm::dmat4& matrix, std::vector<float>& numbers) {
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 4; ++r) numbers.push_back(static_cast<float>(matrix[c][r]));
  }
}

/// 1 where the weights sum to one within their float precision, so that they are written as they are.
double weight_scale(std::span<const rig::Influence> influences) {
  double sum = 0;
  for (const rig::Influence& influence : influences) sum += influence.weight;
  return std::abs(sum - 1.0) < 2e-7 || !(sum > 0.0) ? 1.0 : 1.0 / sum;
}

}  // namespace

GlbSkin::GlbSkin(const document::Model& model) : model_(model) {
  in_skin_.assign(joints().size(), false);
  for (std::size_t j = 0; j < joints().size(); ++j) in_skin_[j] = joints()[j].inverse_bind != glm::dmat4(1);
  for (const mesh::Part& part : model_.mesh->parts()) {
    bindings_.push_back(binding_of(part));
    if (bindings_.back() != Binding::skinned) continue;
    for (std::uint32_t v = part.first_vertex; v < part.first_vertex + part.vertex_count; ++v) {
      const auto influences = model_.skeleton->influences_of(v);
      for (const rig::Influence& influence : influences) in_skin_[influence.joint] = true;
      has_still_ = has_still_ || influences.empty();
    }
  }
}

Binding GlbSkin::binding_of(const mesh::Part& part) const {
  if (!model_.skeleton) return Binding::free;
  bool none = true;
  bool rigid = true;
  const auto first = model_.skeleton->influences_of(part.first_vertex);
  for (std::uint32_t v = part.first_vertex; v < part.first_vertex + part.vertex_count; ++v) {
    const auto influences = model_.skeleton->influences_of(v);
    none = none && influences.empty();
    rigid = rigid && influences.size() == 1 && influences[0].weight == 1.0 && influences[0].joint == first[0].joint &&
            joints()[influences[0].joint].inverse_bind == glm::dmat4(1);
  }
  return none ? Binding::free : rigid ? Binding::rigid : Binding::skinned;
}

void GlbSkin::write_joints(GlbNodes& out) const {
  std::size_t parameter = document::weight_count(model_);
  for (const rig::Joint& joint : joints()) {
    json::Json own = {{"joint", true}, {"posable", joint.posable}};
    glm::dvec3 angles(0);
    if (joint.posable) {
      for (int axis = 0; axis < 3; ++axis) angles[axis] = model_.pose[parameter++];
      own["minimum"] = vector_json(joint.minimum);
      own["maximum"] = vector_json(joint.maximum);
      if (angles != glm::dvec3(0)) own["values"] = vector_json(angles);
    }
    glm::dquat rotation = joint.rest_rotation;
    if (angles != glm::dvec3(0)) rotation = rotation * geometry::quaternion_from_xyz(angles);
    const double length = std::sqrt(glm::dot(rotation, rotation));
    if (std::abs(length - 1.0) > 1e-12) rotation = rotation / length;
    if (rotation != joint.rest_rotation) own["rest_rotation"] = vector_json(joint.rest_rotation);
    if (glm::dmat4(glm::mat4(joint.inverse_bind)) != joint.inverse_bind)
      own["inverse_bind"] = numbers_of(joint.inverse_bind);
    json::Json node = json::Json::object();
    if (!joint.name.empty()) node["name"] = joint.name;
    if (joint.translation != glm::dvec3(0)) node["translation"] = vector_json(joint.translation);
    if (rotation != glm::dquat(1, 0, 0, 0)) node["rotation"] = vector_json(rotation);
    if (joint.scale != glm::dvec3(1)) node["scale"] = vector_json(joint.scale);
    node["extras"] = {{k_extras_key, std::move(own)}};
    out.nodes.push_back(std::move(node));
    if (joint.parent >= 0) {
      out.nodes[static_cast<std::size_t>(joint.parent)]["children"].push_back(out.nodes.size() - 1);
    } else {
      out.scene.push_back(out.nodes.size() - 1);
    }
  }
}

void GlbSkin::write_skin(GltfBuilder& builder, GlbNodes& out) {
  if (std::find(in_skin_.begin(), in_skin_.end(), true) == in_skin_.end()) return;
  json::Json members = json::Json::array();
  std::vector<float> binds;
  skin_place_.assign(in_skin_.size(), k_no_skin);
  for (std::size_t j = 0; j < in_skin_.size(); ++j) {
    if (!in_skin_[j]) continue;
    skin_place_[j] = members.size();
    members.push_back(j);
    add_bind(joints()[j].inverse_bind, binds);
  }
  if (has_still_) {
    still_place_ = members.size();
    members.push_back(out.nodes.size());
    add_bind(glm::dmat4(1), binds);
    out.scene.push_back(out.nodes.size());
    out.nodes.push_back({{"name", "still"}, {"extras", {{k_extras_key, {{"still", true}}}}}});
  }
  if (out.scene.size() > 1) {
    out.nodes.push_back({{"name", "joints"}, {"children", out.scene}, {"extras", {{k_extras_key, {{"group", true}}}}}});
    out.scene = json::Json::array({out.nodes.size() - 1});
  }
  builder.add("skins", {{"joints", std::move(members)},
                        {"inverseBindMatrices", builder.add_floats(binds, "MAT4", BufferUse::plain, false)}});
}

void GlbSkin::write_weights(const mesh::Part& part, GltfBuilder& builder, json::Json& attributes) const {
  std::size_t most = 1;
  for (std::uint32_t v = part.first_vertex; v < part.first_vertex + part.vertex_count; ++v) {
    most = std::max(most, model_.skeleton->influences_of(v).size());
  }
  for (std::size_t set = 0; 4 * set < most; ++set) {
    std::vector<std::uint32_t> joint_numbers;
    std::vector<float> weights;
    for (std::uint32_t v = part.first_vertex; v < part.first_vertex + part.vertex_count; ++v) {
      const auto influences = model_.skeleton->influences_of(v);
      const double scale = weight_scale(influences);
      for (std::size_t i = 4 * set; i < 4 * set + 4; ++i) {
        const bool still = influences.empty() && i == 0;
        joint_numbers.push_back(still                   ? static_cast<std::uint32_t>(still_place_)
                                : i < influences.size() ? static_cast<std::uint32_t>(skin_place_[influences[i].joint])
                                                        : 0U);
        weights.push_back(still                   ? 1.0F
                          : i < influences.size() ? static_cast<float>(influences[i].weight * scale)
                                                  : 0.0F);
      }
    }
    const std::string suffix = std::to_string(set);
    attributes["JOINTS_" + suffix] = builder.add_joints(joint_numbers);
    attributes["WEIGHTS_" + suffix] = builder.add_floats(weights, "VEC4", BufferUse::vertices, false);
  }
}

}  // namespace penpose::io
