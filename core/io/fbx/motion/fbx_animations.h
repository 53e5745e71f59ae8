#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/document/model.h"
#include "core/io/fbx/fbx_meshes.h"

namespace penpose::io {

/// The takes of the file: keys of shapes and of joints, where their curves have some, where a channel goes from one
/// shape to another, and at every frame in between where a curve is no straight line. Takes that reach before zero
/// begin there. Keys that would take more than `most_numbers` in all are fewer, or left out, with a note.
[[nodiscard]] std::vector<document::Animation> read_fbx_animations(const FbxScene& scene, const FbxTakes& takes,
                                                                   FbxPlaces& places, const FbxJoints& joints,
                                                                   const FbxMeshes& meshes, std::size_t most_numbers,
                                                                   std::vector<std::string>& notes);

}  // namespace penpose::io
