#pragma once

#include <vector>

#include "firmware_io/device/hid_interface.h"

namespace penpose::device {

/// All HID interfaces of the system, sorted by where they are plugged in: those with a /dev/hidrawN, and USB
/// interfaces without one because their driver refused them, they have no driver, or another program uses them. Opens
/// no device. Strings are not read; report lengths are those of the descriptor.
[[nodiscard]] std::vector<HidInterface> list_interfaces();

}  // namespace penpose::device
