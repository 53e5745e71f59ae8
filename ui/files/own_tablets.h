#pragma once

#include <string>

#include "core/base/result.h"
#include "firmware_io/decode/table/tablet_table.h"

namespace penpose::files {

inline constexpr const char* k_tablets_option = "--tablets";
inline constexpr const char* k_tablets_help =
    "A file of your own tablets, or a configuration of OpenTabletDriver; goes before the known ones";

/// The tablets of the file that the option names; none where it names no file.
[[nodiscard]] base::Result<decode::TabletTable> read_own_tablets(const std::string& path);

}  // namespace penpose::files
