#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/rig/skeleton.h"

namespace penpose::document {

/// The bones of a human figure that programs agree on (VRMC_vrm 1.0, humanoid), parents before their children.
enum class HumanBone : std::uint8_t {
  hips,
  spine,
  chest,
  upper_chest,
  neck,
  head,
  left_eye,
  right_eye,
  jaw,
  left_upper_leg,
  left_lower_leg,
  left_foot,
  left_toes,
  right_upper_leg,
  right_lower_leg,
  right_foot,
  right_toes,
  left_shoulder,
  left_upper_arm,
  left_lower_arm,
  left_hand,
  right_shoulder,
  right_upper_arm,
  right_lower_arm,
  right_hand,
  left_thumb_metacarpal,
  left_thumb_proximal,
  left_thumb_distal,
  left_index_proximal,
  left_index_intermediate,
  left_index_distal,
  left_middle_proximal,
  left_middle_intermediate,
  left_middle_distal,
  left_ring_proximal,
  left_ring_intermediate,
  left_ring_distal,
  left_little_proximal,
  left_little_intermediate,
  left_little_distal,
  right_thumb_metacarpal,
  right_thumb_proximal,
  right_thumb_distal,
  right_index_proximal,
  right_index_intermediate,
  right_index_distal,
  right_middle_proximal,
  right_middle_intermediate,
  right_middle_distal,
  right_ring_proximal,
  right_ring_intermediate,
  right_ring_distal,
  right_little_proximal,
  right_little_intermediate,
  right_little_distal,
};
inline constexpr std::size_t k_human_bones = 55;

/// As VRM 1.0 names it: "leftUpperArm".
[[nodiscard]] std::string_view name_of(HumanBone bone);
/// The bone that VRM 1.0 names so; none: there is no such bone.
[[nodiscard]] std::optional<HumanBone> human_bone_named(std::string_view name);
/// The bone that VRM 0.x names so. Its thumbs are proximal, intermediate and distal; 1.0 calls them metacarpal,
/// proximal and distal.
[[nodiscard]] std::optional<HumanBone> human_bone_named_in_vrm0(std::string_view name);
/// The bone that it hangs on (VRMC_vrm 1.0, humanoid, list of bones); none: the hips.
[[nodiscard]] std::optional<HumanBone> parent_of(HumanBone bone);

/// Which joint of a skeleton is which bone.
struct Humanoid {
  std::array<std::int32_t, k_human_bones> joint_of;  ///< one a bone; -1: the skeleton has none

  Humanoid() { joint_of.fill(-1); }
  [[nodiscard]] std::optional<std::uint32_t> joint(HumanBone bone) const {
    const std::int32_t at = joint_of[static_cast<std::size_t>(bone)];
    return at < 0 ? std::nullopt : std::optional(static_cast<std::uint32_t>(at));
  }
  [[nodiscard]] bool empty() const;
};

/// Told by the names of joints, as VRoid Studio, Unity, Mixamo and Ready Player Me, Blender's Rigify and MMD's tools
/// give them. A name that says two bones says neither; of several joints the one nearest to the root is taken.
[[nodiscard]] Humanoid humanoid_by_names(std::span<const rig::Joint> joints);

}  // namespace penpose::document
