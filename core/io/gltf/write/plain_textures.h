#pragma once

#include <string>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/result.h"

namespace penpose::io {

/// A .glb file with its WebP images as PNG, so that programs without EXT_texture_webp show them (Blender before 4.0).
/// All else stays as it is. `notes`: images that stay WebP, one line each. Precondition: the file is one that this
/// program wrote. Errors: over 4 GiB.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> with_plain_textures(base::Bytes glb,
                                                                          std::vector<std::string>& notes);

}  // namespace penpose::io
