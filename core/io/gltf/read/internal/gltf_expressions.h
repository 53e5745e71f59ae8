#pragma once

#include "core/io/gltf/read/internal/gltf_document.h"
#include "core/io/gltf/read/internal/gltf_meshes.h"
#include "core/io/gltf/read/internal/gltf_shapes.h"

namespace penpose::io {

/// Adds the expressions of a VRM avatar as blend shapes of their names: VRM 1.0 (extension VRMC_vrm, expressions,
/// preset and custom) and VRM 0.x (extension VRM, blendShapeMaster). An expression is a sum of morph targets times
/// their weights. What else an expression does (colours, textures) is left out, with a note; so are expressions whose
/// name a morph target has already. Binds of an expression that name a node, mesh or target
/// that is not there are left out, with a note each.
void add_expressions(GltfDocument& document, const GltfMeshes& meshes, GltfShapes& shapes);

}  // namespace penpose::io
