#pragma once

#include <memory>

#include "firmware_io/device/hid_interface.h"
#include "firmware_io/device/report_source.h"

namespace penpose::device {

/// Opens a USB interface through libusb: takes it from the kernel's driver, which gets it back when the source is
/// closed or this process dies (see DriverGuard). Meanwhile the pen does not move the desktop's pointer. Reads an
/// unknown report descriptor from the device and fills it in, with the lengths that follow from it. Errors: not
/// permitted, in use by another program, or without an endpoint that gives reports.
[[nodiscard]] base::Result<std::unique_ptr<ReportSource>> open_libusb(HidInterface& interface);

}  // namespace penpose::device
