#pragma once

#include "core/io/gltf/write/patch/patch_state.h"

namespace penpose::io {

/// Keeps what a VRM avatar says of meshes and morph targets true: binds of expressions follow targets that got another
/// number and go with those that are gone; copies of a mesh (PatchColumns) are bound, and seen in first person, as the
/// mesh is. After PatchColumns.
void patch_vrm(PatchState& state);

}  // namespace penpose::io
