#include "core/io/gltf/vrm/vrm_extension.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/io/gltf/internal/gltf_extras.h"

namespace penpose::io {
namespace {

const json::Json* vrm_extension_of(const json::Json& document, const char* name) {
  const json::Json* extensions = json::find(document, "extensions");
  return extensions == nullptr ? nullptr : json::find(*extensions, name);
}

const json::Json* vrm_extras(const json::Json& document) {
  const json::Json* extras = json::find(document, "extras");
  return extras == nullptr ? nullptr : json::find(*extras, k_extras_key);
}

/// "humanoid" of penpose's extras: {BONE: number of the joint}.
document::Humanoid own_humanoid(const json::Json& document, const std::vector<std::int32_t>& joint_of_node) {
  document::Humanoid result;
  const json::Json* own = vrm_extras(document);
  const json::Json* listed = own == nullptr ? nullptr : json::find(*own, "humanoid");
  if (listed == nullptr || !listed->is_object()) return result;
  const std::int32_t last = joint_of_node.empty() ? -1 : *std::max_element(joint_of_node.begin(), joint_of_node.end());
  for (const auto& [name, joint] : listed->items()) {
    const auto bone = document::human_bone_named(name);
    const auto number = json::whole_number(joint, 0, last);
    if (bone && number) result.joint_of[static_cast<std::size_t>(*bone)] = static_cast<std::int32_t>(*number);
  }
  return result;
}

class Bones {
 public:
  explicit Bones(const std::vector<std::int32_t>& joint_of_node) : joint_of_node_(joint_of_node) {}

  void take(std::optional<document::HumanBone> bone, const json::Json& of) {
    const json::Json* node = json::find(of, "node");
    const auto number = node == nullptr || joint_of_node_.empty()
                            ? std::nullopt
                            : json::whole_number(*node, 0, static_cast<std::int64_t>(joint_of_node_.size()) - 1);
    if (!bone || !number) return;
    result.joint_of[static_cast<std::size_t>(*bone)] = joint_of_node_[static_cast<std::size_t>(*number)];
  }

  document::Humanoid result;

 private:
  const std::vector<std::int32_t>& joint_of_node_;
};

}  // namespace

bool is_vrm_avatar(const json::Json& document) {
  return vrm_extension_of(document, "VRMC_vrm") != nullptr || vrm_extension_of(document, "VRM") != nullptr;
}

double vrm_front_yaw_degrees(const json::Json& document) {
  if (vrm_extension_of(document, "VRMC_vrm") != nullptr) return 0;
  if (vrm_extension_of(document, "VRM") != nullptr) return 180;
  const json::Json* own = vrm_extras(document);
  const json::Json* yaw = own == nullptr ? nullptr : json::find(*own, "front_yaw_degrees");
  const double degrees = yaw == nullptr ? 0 : json::number(*yaw).value_or(0);
  return std::abs(degrees) <= 360 ? degrees : 0;
}

bool is_vrm_animation(const json::Json& document) {
  const json::Json* meshes = json::find(document, "meshes");
  const bool none = meshes == nullptr || !meshes->is_array() || meshes->empty();
  return none && vrm_extension_of(document, "VRMC_vrm_animation") != nullptr;
}

document::Humanoid vrm_humanoid(const json::Json& document, const std::vector<std::int32_t>& joint_of_node) {
  Bones bones(joint_of_node);
  const json::Json* vrm0 = vrm_extension_of(document, "VRM");
  const json::Json* vrm1 = vrm_extension_of(document, "VRMC_vrm");
  if (vrm1 == nullptr) vrm1 = vrm_extension_of(document, "VRMC_vrm_animation");
  const json::Json* vrm = vrm1 != nullptr ? vrm1 : vrm0;
  const json::Json* humanoid = vrm == nullptr ? nullptr : json::find(*vrm, "humanoid");
  const json::Json* listed = humanoid == nullptr ? nullptr : json::find(*humanoid, "humanBones");
  if (listed == nullptr) return own_humanoid(document, joint_of_node);
  if (vrm1 != nullptr && listed->is_object()) {
    for (const auto& [name, bone] : listed->items()) bones.take(document::human_bone_named(name), bone);
  }
  if (vrm1 == nullptr && listed->is_array()) {
    for (const json::Json& bone : *listed) {
      const json::Json* name = json::find(bone, "bone");
      if (name == nullptr || !name->is_string()) continue;
      bones.take(document::human_bone_named_in_vrm0(name->get_ref<const std::string&>()), bone);
    }
  }
  return bones.result;
}

}  // namespace penpose::io
