#pragma once

#include <memory>

#include "firmware_io/device/hid_interface.h"
#include "firmware_io/device/report_source.h"

namespace penpose::device {

/// Opens an interface through hidapi and /dev/hidrawN, in parallel with the kernel's driver. Strings are read from the
/// USB device, which needs no interface.
[[nodiscard]] base::Result<std::unique_ptr<ReportSource>> open_hidraw(const HidInterface& interface);

}  // namespace penpose::device
