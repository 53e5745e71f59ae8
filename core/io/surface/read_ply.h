#pragma once

#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "core/document/model.h"

namespace penpose::io {

/// Reads PLY 1.0: text and binary in either byte order, polygons of any size, normals where there are nx, ny, nz. Other
/// elements and properties are skipped; colours are noted. Errors: place is "line N" or "byte offset N".
[[nodiscard]] base::Result<document::Model> read_ply(base::Bytes bytes);

}  // namespace penpose::io
