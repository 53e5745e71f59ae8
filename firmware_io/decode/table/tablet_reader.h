#pragma once

#include <string_view>

#include "core/base/result.h"
#include "firmware_io/decode/table/tablet_table.h"

namespace penpose::decode {

/// Reads a file of tablets in the project's own form (tablets/README.md) or a configuration file of OpenTabletDriver;
/// its members tell which. Errors name the JSON pointer.
[[nodiscard]] base::Result<TabletTable> read_tablet_file(std::string_view text);

}  // namespace penpose::decode
