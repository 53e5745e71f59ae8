#pragma once

#include <vector>

#include "firmware_io/decode/table/json_place.h"
#include "firmware_io/decode/table/tablet_table.h"

namespace penpose::decode {

/// What a tablet's USB strings must hold: an object of patterns, each under the index of its string, 0 to 255. Of an
/// absent place none.
[[nodiscard]] std::vector<TabletIdentifier::StringCheck> read_device_strings(const JsonPlace& place);

}  // namespace penpose::decode
