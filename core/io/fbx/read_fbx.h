#pragma once

#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "core/document/model.h"
#include "core/io/model/read_model.h"

namespace penpose::io {

/// An FBX file of version 7.x, binary or text: meshes, blend shapes, skins, nodes, and keys of shapes and joints.
/// World: +y up, metres. Vertex v of a part is control point v of its mesh. Errors (place: byte offset, line, or the
/// object).
[[nodiscard]] base::Result<document::Model> read_fbx(base::Bytes bytes, const FileResolver& resolve);

}  // namespace penpose::io
