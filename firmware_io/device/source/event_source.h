#pragma once

#include <memory>

#include "firmware_io/device/hid_interface.h"
#include "firmware_io/device/report_source.h"

namespace penpose::device {

/// Opens an event device through libevdev and puts the descriptor of its real ranges into `interface`. Its reports are
/// those of event::EventEncoder, with the times of the kernel; where the kernel's queue was full, the state after it
/// comes and is told as such. Takes no reports. Pens and pads can be exclusive (EVIOCGRAB); fingers stay with the
/// desktop, which one finger belongs to. Errors: not permitted, no input device.
[[nodiscard]] base::Result<std::unique_ptr<ReportSource>> open_event_device(HidInterface& interface);

}  // namespace penpose::device
