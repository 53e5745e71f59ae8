#pragma once

#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "core/document/model.h"

namespace penpose::io {

/// Reads Wavefront OBJ: vertices in the order of the file, polygons of any size, one part for each object ("o") whose
/// vertices lie together in the file. Normals are kept where the faces around a vertex agree on one. Materials, texture
/// coordinates, lines and free-form surfaces are left out and noted. Errors: place is "line N".
[[nodiscard]] base::Result<document::Model> read_obj(base::Bytes bytes);

}  // namespace penpose::io
