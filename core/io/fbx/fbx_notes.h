#pragma once

#include <string>
#include <vector>

#include "core/io/fbx/fbx_scene.h"

namespace penpose::io {

/// Says what of the file is not read and changes how it looks or moves: one line each.
void add_fbx_notes(const FbxScene& scene, std::vector<std::string>& notes);

}  // namespace penpose::io
