#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/io/gltf/internal/gltf_extras.h"
#include "core/io/gltf/read/internal/gltf_document.h"
#include "core/io/gltf/read/internal/gltf_meshes.h"
#include "core/rig/blend_shapes.h"

namespace penpose::io {

struct GltfShapes {
  std::vector<rig::BlendShape> shapes;
  std::vector<double> values;                       ///< the pose, one a shape
  std::vector<std::vector<std::size_t>> of_target;  ///< for every part and target of it, the shape
};

/// Reads the morph targets of all parts, in the order of the file. Targets of one name are one shape across parts.
/// Names: extras.targetNames of the mesh, else of the
/// primitive (VRM 0.x), else PART.targetN. Values: weights of the node, else of the mesh. Errors:
/// place is a JSON pointer.
[[nodiscard]] base::Result<GltfShapes> read_shapes(GltfDocument& document, const GltfMeshes& meshes,
                                                   const RootExtras& extras);

/// Puts the shapes in the order in which the extras list them, others after them as they came, and then, at the end and
/// in their order, one for each of these deformers (empty where the file has no target of its name). Returns how many
/// shapes come before the deformers.
std::size_t order_shapes(GltfShapes& shapes, const RootExtras& extras, const std::vector<std::string>& deformers);

}  // namespace penpose::io
