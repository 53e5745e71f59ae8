#pragma once

#include <vector>

#include "core/document/model.h"
#include "core/io/fbx/fbx_meshes.h"
#include "core/io/fbx/fbx_scene.h"

namespace penpose::io {

/// The takes of the file: keys of shapes and of joints, where their curves have some, and thirty a second in between
/// where a curve is no straight line. `shapes`: of the model, in its order. A curve that cannot be read is left out.
[[nodiscard]] std::vector<document::Animation> read_fbx_animations(const FbxScene& scene, const FbxJoints& joints,
                                                                   const std::vector<rig::BlendShape>& shapes);

}  // namespace penpose::io
