#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/document/model.h"
#include "core/io/gltf/read/internal/gltf_document.h"
#include "core/io/gltf/read/internal/gltf_meshes.h"
#include "core/io/gltf/read/internal/gltf_shapes.h"

namespace penpose::io {

/// Keys as the file has them: `per_key` numbers for each element that is animated.
struct GltfKeys {
  document::Interpolation interpolation = document::Interpolation::linear;
  std::vector<double> times_s;  ///< ascending, 0 or more
  std::vector<double> values;   ///< with tangents for cubic splines; finite
};
/// The keys of one sampler; `type` is tinygltf's number of its values. Keys whose times do not ascend are left out with
/// a note. Errors: an interpolation that is not known, no key, values that are not finite or not one a key; place is a
/// JSON pointer, `pointer` that of the channel.
[[nodiscard]] base::Result<GltfKeys> read_keys(GltfDocument& document, const tinygltf::AnimationSampler& sampler,
                                               int type, std::size_t per_key, const std::string& pointer);

/// Reads the animations of morph weights and joints. Weights of several meshes become one channel over all shapes where
/// their keys fall on the same times. Channels that cannot be read are left out; that and what cannot be kept is noted.
/// `from`: the number in the file of each animation that is returned.
[[nodiscard]] std::vector<document::Animation> read_animations(GltfDocument& document, const GltfMeshes& meshes,
                                                               const GltfShapes& shapes,
                                                               const std::vector<std::int32_t>& joint_of_node,
                                                               std::vector<std::size_t>& from);

}  // namespace penpose::io
