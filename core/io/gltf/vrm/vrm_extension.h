#pragma once

#include <cstdint>
#include <vector>

#include "core/base/json/json.h"
#include "core/document/humanoid.h"

namespace penpose::io {

/// Where a VRM avatar looks, degrees about +y from +z: 180 for VRM 0.x, which looks along -z (VRM 0.x, "the model faces
/// the -Z axis"), 0 for VRM 1.0; for other files what
/// penpose has written (gltf_extras.h), or 0.
[[nodiscard]] double vrm_front_yaw_degrees(const json::Json& document);

/// Whether the file is a VRM avatar, of either version.
[[nodiscard]] bool is_vrm_avatar(const json::Json& document);

/// Whether the file is a VRM animation (VRMC_vrm_animation) and no model: it has no mesh.
[[nodiscard]] bool is_vrm_animation(const json::Json& document);

/// The humanoid that a VRM avatar (VRMC_vrm, humanoid.humanBones by name; VRM, humanoid.humanBones as a list) or a VRM
/// animation (VRMC_vrm_animation, the same as VRMC_vrm) says it has, or else what penpose has written (gltf_extras.h).
/// `joint_of_node`: the joint of each node, or -1. Empty: it is none of them. Bones of nodes that are none, or no
/// joint, are left out.
[[nodiscard]] document::Humanoid vrm_humanoid(const json::Json& document,
                                              const std::vector<std::int32_t>& joint_of_node);

}  // namespace penpose::io
