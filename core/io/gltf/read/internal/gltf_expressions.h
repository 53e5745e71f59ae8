#pragma once

#include <vector>

#include "core/document/model.h"
#include "core/io/gltf/read/internal/gltf_document.h"
#include "core/io/gltf/read/internal/gltf_meshes.h"
#include "core/io/gltf/read/internal/gltf_shapes.h"

namespace penpose::io {

/// The expressions of a VRM avatar, as poses of the shapes with their names: VRM 1.0 (extension VRMC_vrm, expressions,
/// preset and custom) and VRM 0.x (extension VRM, blendShapeMaster, weights in percent). Values are the weights that
/// their binds give to targets at full expression; parameters are numbers of `shapes`, ascending, below `count`.
/// Targets of one name are one shape: binds to several of them count once, by the largest. What else an expression does
/// (colours, textures) stays in the file and is not shown, with a note; so are expressions without a bind that can be
/// used, those of a name that another has, and more than 1,000 of them. Binds that name a node, mesh or target that is
/// not there are left out, with a note each.
[[nodiscard]] std::vector<document::Expression> read_expressions(GltfDocument& document, const GltfMeshes& meshes,
                                                                 const GltfShapes& shapes, std::size_t count);

}  // namespace penpose::io
