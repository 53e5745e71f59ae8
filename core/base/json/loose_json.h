#pragma once

#include "core/base/json/json.h"

namespace penpose::json {

/// As parse_json, but numbers that JSON does not have are null instead of the end of it all: NaN, Infinity and
/// -Infinity, as Python writes them, and numbers too large for a double. For trackers' files, where a point that is no
/// number is a frame without a face.
[[nodiscard]] base::Result<Json> parse_loose_json(base::Bytes bytes);

}  // namespace penpose::json
