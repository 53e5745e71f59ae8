#pragma once

#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "core/document/sound/mouths.h"

namespace penpose::speech {

/// Mouths of a JSON file: {"mouths": [{"name": "closed", "values": {"jawOpen": 0, ...}}, ...]}, 1 to k_most_mouths of
/// them. Errors (place: JSON pointer): another form, a name that is missing or there twice.
[[nodiscard]] base::Result<std::vector<document::Mouth>> read_mouth_file(base::Bytes bytes);

}  // namespace penpose::speech
