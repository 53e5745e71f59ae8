#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/document/model.h"

namespace penpose::io {

/// A binary glTF 2.0 file of the whole model: what is written reads back with the same document::state_hash. Each part
/// is a mesh, the pose stands in the weights of the meshes and the rotations of the joints, and what glTF has no place
/// for is under the extras key "penpose". Normals are made where the model has none. Limits of the format: skin weights
/// and keys of animations are rounded to float.
///
/// Sketched deformers are baked to as many more morph targets as keep every vertex within `bake_tolerance` (a share of
/// the model's size) at every amount, so that the file plays the same in any viewer; reading the file back takes them
/// for what they are. Viewers mix weights evenly between keys, which deformers do not: where that shows, keys are added
/// in between, and reading drops them again.
///
/// A model that was read from glTF (Model::source) is that file with what was changed: all else in it, known or not,
/// stays as it was, byte for byte, and a model without a change is the file itself. Where `bare` asks for it, or the
/// model has got another surface or other joints, the file has what penpose knows alone, and a note says what is lost.
struct WriteOptions {
  double bake_tolerance = 1e-4;
  double fps = 60;        ///< frames a second of formats that give every frame
  std::string stem = {};  ///< what files beside a .gltf are named after; write_model takes that of the file itself
  bool plain_textures = false;  ///< WebP images of a .glb or .vrm file become PNG, for programs that read no WebP
  bool bare = false;            ///< nothing of the file that the model was read from, but what penpose knows
};
/// What came of it, for whoever wants to say so.
struct WriteReport {
  std::size_t targets = 0;  ///< morph targets in all
  std::size_t baked = 0;    ///< of them made for deformers beside their own
  double bake_error = 0;    ///< farthest that baking moves a vertex, at keys and in between, share of the model's size
  std::vector<std::string> notes = {};  ///< what the format has no place for, one line each
  /// Files that belong beside the one that was written, by their relative paths.
  std::map<std::string, std::vector<std::uint8_t>> files = {};
};
/// Viewers that show no more morph targets at a time than this are common.
inline constexpr std::size_t k_common_targets = 8;
[[nodiscard]] base::Result<std::vector<std::uint8_t>> write_glb(const document::Model& model,
                                                                const WriteOptions& options = {},
                                                                WriteReport* report = nullptr);

/// The same as a text file. Its buffers lie beside it (WriteReport::files): those of the file that the model was read
/// from as they were, with its pictures, and one for what is new.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> write_gltf(const document::Model& model,
                                                                 const WriteOptions& options, WriteReport* report);

/// A Wavefront OBJ file of the positions at the model's pose, one object a part, with smooth normals. Coordinates are
/// rounded to float.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> write_obj(const document::Model& model);

/// The name of a file without its folder and its extension.
[[nodiscard]] std::string stem_of(std::string_view file_name);

/// Writes in the format that the file name's extension asks for. Errors: no format that is written has it
/// (extensions_written), those of the writer.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> write_model(const document::Model& model,
                                                                  std::string_view file_name,
                                                                  const WriteOptions& options = {},
                                                                  WriteReport* report = nullptr);

}  // namespace penpose::io
