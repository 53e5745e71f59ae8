#pragma once

#include "core/io/model/write_model.h"

namespace penpose::io {

/// A binary FBX file of version 7.4: meshes in metres, +y up, with their shapes, skins and joints at the model's pose,
/// the colours of materials, and animations. Rotations of joints are angles about x, y and z, with a key a frame of
/// `fps` where they turn. What FBX or this writer has no place for is named in the report.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> write_fbx(const document::Model& model,
                                                                const WriteOptions& options, WriteReport& report);

}  // namespace penpose::io
