#pragma once

#include <memory>

#include "firmware_io/device/hid_interface.h"
#include "firmware_io/device/report_source.h"

namespace penpose::device {

/// Opens an event device through libevdev, in parallel with the desktop as hidraw is, and puts the descriptor of its
/// real ranges into `interface`. Its reports are those of event::EventEncoder, with the times of the kernel; where the
/// kernel's queue was full, the state after it comes and is told as such. Takes no reports. Errors: not permitted, and
/// another program has it for itself.
[[nodiscard]] base::Result<std::unique_ptr<ReportSource>> open_event_device(HidInterface& interface);

}  // namespace penpose::device
