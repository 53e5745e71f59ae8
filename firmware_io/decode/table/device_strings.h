#pragma once

#include <vector>

#include "firmware_io/decode/table/json_place.h"
#include "firmware_io/decode/table/tablet_table.h"

namespace penpose::decode {

/// Patterns that a tablet's USB strings must match: an object with each pattern under the index of its string, 0 to
/// 255. None for an absent place.
[[nodiscard]] std::vector<TabletIdentifier::StringCheck> read_device_strings(const JsonPlace& place);

}  // namespace penpose::decode
