#pragma once

#include <string_view>

#include "firmware_io/decode/table/tablet_table.h"

namespace penpose::decode {

class JsonPlace;

/// The protocol that decodes what a report parser class of OpenTabletDriver decodes, found by the last part of the
/// class's name; empty when none does.
[[nodiscard]] std::string_view protocol_of_parser(std::string_view class_name);

/// Reads a configuration file of OpenTabletDriver as its users have it (versions 0.5 and 0.6; what it says beyond what
/// a Tablet holds is passed over). Things wrong go to the error of `file`; what is returned then means nothing.
[[nodiscard]] Tablet read_open_tablet_driver(const JsonPlace& file);

}  // namespace penpose::decode
