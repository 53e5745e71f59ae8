#pragma once

#include <optional>
#include <string>

#include "firmware_io/decode/described/light_report.h"
#include "firmware_io/device/live_tablet.h"

namespace penpose::device {

/// Whether the kernel's driver has the tablet and therefore switches its lights itself, with every press of their key.
[[nodiscard]] bool kernel_switches_lights(const LiveTablet& tablet);

/// The lights that the kernel's driver has switched on; nothing if it has none. `folder` is replaced in tests.
[[nodiscard]] std::optional<decode::Lights> seen_lights(const HidInterface& interface,
                                                        const std::string& folder = "/sys/bus/hid/devices");

}  // namespace penpose::device
