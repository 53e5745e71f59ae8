#pragma once

#include "core/base/byte_reader.h"
#include "core/base/json/json.h"
#include "core/base/result.h"

namespace penpose::io {

/// A tracker's file as one value; of a file of a value a line, as programs write that add a line a frame, a list of
/// them. Errors: those of parse_loose_json; a line that is none.
[[nodiscard]] base::Result<json::Json> read_json_values(base::Bytes bytes);

}  // namespace penpose::io
