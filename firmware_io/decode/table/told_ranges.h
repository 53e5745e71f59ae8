#pragma once

#include <optional>
#include <string>

#include "core/base/byte_reader.h"
#include "firmware_io/decode/sample/device_identity.h"
#include "firmware_io/decode/sample/pen_sample.h"
#include "firmware_io/hid/report_descriptor.h"

namespace penpose::decode {

// Tablets of Huion's second protocol (Huion, Gaomon) tell the ranges of their pen in a USB string that is no text, and
// send reports of their own once it was read. Source: Linux, drivers/hid/hid-uclogic-params.c.

inline constexpr std::uint16_t k_vendor_huion = 0x256c;
inline constexpr std::uint8_t k_ranges_string = 200;
/// How tablets of this protocol lay out their reports.
inline constexpr const char* k_ranges_protocol = "huion_giano";

/// How string 200 of a device is kept: text as it is, other bytes in hexadecimal. `utf16`: lowest byte first, without
/// the header of the descriptor.
[[nodiscard]] std::string ranges_text(base::Bytes utf16);

/// The ranges of x, y and pressure, and the resolution, that the device has told. Nothing where it did not, or where
/// the interface describes no report 8 of twelve bytes, which its pen sends.
[[nodiscard]] std::optional<PenAxes> told_ranges(const DeviceIdentity& device, const hid::ReportDescriptor& descriptor);

}  // namespace penpose::decode
