#pragma once

#include <optional>

#include "core/base/byte_reader.h"
#include "core/base/result.h"

namespace penpose::io {

/// What a file is that is certainly no model of a format that is read, and what to do about it: a web page in place of
/// a download, a Git LFS pointer, an archive, a file of another program. Nothing for bytes that a format is recognised
/// by, and for any others. Place: "byte offset 0".
[[nodiscard]] std::optional<base::Error> foreign_file(base::Bytes bytes);

}  // namespace penpose::io
