#pragma once

#include <algorithm>
#include <array>

#include "core/base/byte_reader.h"

namespace penpose::hid {

/// An empty application collection with a vendor usage (k_page_event, usage 0x7664), the end of every report descriptor
/// that stands for a Linux input device (firmware_io/event). What a driver of the kernel has read already is in its
/// reports, so the formats that belong to the device's ids do not hold for them.
inline constexpr std::array<std::uint8_t, 8> k_event_mark{0x0b, 0x64, 0x76, 0x65, 0xff, 0xa1, 0x01, 0xc0};

/// Whether a report descriptor stands for a Linux input device.
[[nodiscard]] inline bool has_event_mark(base::Bytes descriptor) {
  return descriptor.size() >= k_event_mark.size() &&
         std::equal(k_event_mark.begin(), k_event_mark.end(), descriptor.end() - k_event_mark.size());
}

}  // namespace penpose::hid
