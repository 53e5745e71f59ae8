#pragma once

#include "core/base/json/json.h"
#include "core/base/result.h"
#include "core/io/gltf/read/internal/gltf_document.h"

namespace penpose::io {

/// Unpacks what EXT_meshopt_compression (and KHR_meshopt_compression) and KHR_draco_mesh_compression hold: its bytes
/// become buffers of their own, and the buffer views, accessors and primitives of `vetted` (vet_gltf) speak of those,
/// so that whoever reads on sees a file without compression. Indices of buffer views, accessors and primitives stay;
/// new ones come after them. What is unpacked stays below 1 MiB and 40 times `file_bytes`. Returns how many bytes were
/// unpacked. Errors: place is a JSON pointer.
[[nodiscard]] base::Result<std::uint64_t> unpack_gltf(GltfDocument& document, json::Json& vetted,
                                                      std::uint64_t file_bytes);

/// Whether a buffer is marked as one that only stands for compressed bytes, and may have none.
[[nodiscard]] bool is_placeholder(const json::Json& buffer);
/// The Draco extension of a primitive; null: none.
[[nodiscard]] const json::Json* draco_of(const json::Json& primitive);

}  // namespace penpose::io
