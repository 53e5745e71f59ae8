#pragma once

#include <cstdint>
#include <vector>

#include "core/base/result.h"
#include "core/document/model.h"
#include "core/io/gltf/read/internal/gltf_document.h"
#include "core/io/gltf/read/internal/gltf_meshes.h"
#include "core/io/gltf/read/internal/gltf_shapes.h"

namespace penpose::io {

/// Reads the animations of morph weights and joints. Weights of several meshes become one channel over all shapes where
/// their keys fall on the same times. What cannot be kept is noted. `from`: the number in the file of each animation
/// that is returned. Errors: place is a JSON pointer.
[[nodiscard]] base::Result<std::vector<document::Animation>> read_animations(
    GltfDocument& document, const GltfMeshes& meshes, const GltfShapes& shapes,
    const std::vector<std::int32_t>& joint_of_node, std::vector<std::size_t>& from);

}  // namespace penpose::io
