#pragma once

#include <memory>

#include "firmware_io/device/hid_interface.h"
#include "firmware_io/device/report_source.h"

namespace penpose::device {

/// Opens a USB interface through libusb: takes it from the kernel's driver, which gets it back when the source is
/// closed and also when this process dies (see DriverGuard). Meanwhile the pen moves no pointer of the desktop.
/// A report descriptor that is not known yet is read from the device and filled in, with the lengths that follow from
/// it. Errors: not permitted, in use by another program, or without an endpoint that gives reports.
[[nodiscard]] base::Result<std::unique_ptr<ReportSource>> open_libusb(HidInterface& interface);

}  // namespace penpose::device
