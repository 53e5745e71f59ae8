#pragma once

#include <string_view>

#include "firmware_io/decode/table/tablet_table.h"

namespace penpose::decode {

class JsonPlace;

/// The protocol that corresponds to a report parser class of OpenTabletDriver, found by the last part of the class's
/// name; empty if there is none.
[[nodiscard]] std::string_view protocol_of_parser(std::string_view class_name);

/// Reads a configuration file of OpenTabletDriver (versions 0.5 and 0.6; data that a Tablet does not hold is skipped).
/// Errors go to the error of `file`; the result is then meaningless.
[[nodiscard]] Tablet read_open_tablet_driver(const JsonPlace& file);

}  // namespace penpose::decode
