#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/json/json.h"
#include "core/base/result.h"
#include "core/io/gltf/read/internal/own_tinygltf.h"
#include "core/io/model/read_model.h"

namespace penpose::io {

/// A glTF file in memory: its structure as tinygltf gives it, after vet_gltf has checked it, and the bytes of its
/// buffers, which stay where they are.
struct GltfDocument {
  tinygltf::Model model;                                          ///< without buffers, extras, textures and cameras
  json::Json json;                                                ///< as in the file, for extras
  std::vector<base::Bytes> buffers;                               ///< one a buffer
  std::vector<std::unique_ptr<std::vector<std::uint8_t>>> owned;  ///< bytes of data: URIs and resolved files
  /// The file itself, where it is kept beyond what is read of it; null: its bytes are somebody else's.
  std::shared_ptr<const std::vector<std::uint8_t>> file;
  std::vector<std::string> notes;
  /// Numbers that accessors may still unfold to. A small file may name the same data, or none at all, very often.
  std::size_t budget = 0;
};

/// Opens a binary (.glb) or text (.gltf) document. The bytes have to outlive what is returned. Errors: place is a byte
/// offset (container, JSON) or a JSON pointer.
[[nodiscard]] base::Result<GltfDocument> open_gltf(base::Bytes bytes, const FileResolver& resolve);

/// The same of a file that whatever is read of it may keep.
[[nodiscard]] base::Result<GltfDocument> open_kept_gltf(base::Bytes bytes, const FileResolver& resolve);

/// The bytes of a URI: a data: URI or a file below the model's folder. Errors: those of buffers.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> read_uri(const std::string& uri, const std::string& pointer,
                                                               const FileResolver& resolve);

/// Whether the bytes start like a binary glTF file.
[[nodiscard]] bool is_glb(base::Bytes bytes);

}  // namespace penpose::io
