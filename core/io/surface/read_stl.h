#pragma once

#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "core/document/model.h"

namespace penpose::io {

/// Reads STL, text or binary. The format has loose triangles; corners of one solid at exactly the same position become
/// one vertex, numbered as they first appear. One part for each solid of a text file. Errors: place is "line N" or
/// "byte offset N".
[[nodiscard]] base::Result<document::Model> read_stl(base::Bytes bytes);

}  // namespace penpose::io
