#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/document/model.h"

namespace penpose::model_io {

/// A binary glTF 2.0 file of the whole model: what is written reads back with the same document::state_hash. Each part
/// is a mesh, the pose stands in the weights of the meshes and the rotations of the joints, and what glTF has no place
/// for is under the extras key "penpose". Normals are made where the model has none. Limits of the format: skin weights
/// and keys of animations are rounded to float.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> write_glb(const document::Model& model);

/// A Wavefront OBJ file of the positions at the model's pose, one object a part, with smooth normals. Coordinates are
/// rounded to float.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> write_obj(const document::Model& model);

/// Writes in the format that the file name's extension asks for: .glb or .obj. Errors: any other extension.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> write_model(const document::Model& model,
                                                                  std::string_view file_name);

}  // namespace penpose::model_io
