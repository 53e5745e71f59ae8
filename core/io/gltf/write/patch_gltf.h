#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/json/json.h"
#include "core/base/result.h"
#include "core/document/model.h"
#include "core/io/model/write_model.h"

namespace penpose::io {

/// What writes the file: a .glb, or a .gltf with files beside it.
enum class GltfContainer : bool { binary, text };

struct PatchedGltf {
  std::vector<std::uint8_t> bytes;
  WriteReport report;
  /// Why the model is no longer that of the file, whose surface or joints others have replaced; then there are no
  /// bytes. Empty: it is.
  std::string cannot;
};

/// The file that a model was read from (Model::source, not null) with what was changed: weights, rotations of joints,
/// morph targets with their names and columns of keys, animations, own extras. All else keeps its bytes, its order and
/// its number; what is new is appended. Joints of a VRM avatar stay in T-pose, and their pose is in own extras alone.
/// Without a change it is the file itself. Reads back with the model's
/// document::state_hash.
///
/// Morph targets that were made for sketched controls get normals where the primitive has some, and tangents where it
/// has some: those of the file, turned as the normals of the moved surface are.
///
/// A .glb is whole: buffers and pictures that lie beside the file are taken into it. A .gltf leaves them beside and has
/// one buffer more, "STEM.bin". `project`: as of write_root_extras. Errors: those of the container.
[[nodiscard]] base::Result<PatchedGltf> patch_gltf(const document::Model& model, const WriteOptions& options,
                                                   const json::Json& project, GltfContainer container);

}  // namespace penpose::io
