#pragma once

#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "core/document/model.h"

namespace penpose::io {

/// Reads text OFF (Geomview), also with normals (NOFF) and colours (COFF), which are left out. Errors: place is "line
/// N".
[[nodiscard]] base::Result<document::Model> read_off(base::Bytes bytes);

}  // namespace penpose::io
