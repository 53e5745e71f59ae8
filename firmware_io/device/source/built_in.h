#pragma once

#include "firmware_io/device/live_tablet.h"

namespace penpose::device {

/// Whether this program was built with what reads tablets that way (PENPOSE_DEVICES, PENPOSE_LIBUSB).
[[nodiscard]] bool reads_through(Transport transport);

}  // namespace penpose::device
