#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "firmware_io/device/hid_interface.h"
#include "firmware_io/event/event_device.h"

namespace penpose::device {

/// The event devices of the system that have a pen, the keys of a tablet or fingers, sorted by where they are plugged
/// in. Opens no device, so the ranges in their descriptors are not the devices' own yet. Costs three small files for
/// each input device of the system, and udev's look at those that it gives.
[[nodiscard]] std::vector<HidInterface> list_event_devices(const std::string& folder = "/sys/class/input");

/// What an input device's folder in /sys says of it, with made-up ranges; nothing known where files are missing.
[[nodiscard]] event::EventAxes read_event_facts(const std::string& folder);

}  // namespace penpose::device
