#pragma once

#include <string>
#include <vector>

#include "core/base/byte_reader.h"
#include "firmware_io/device/source/libusb/internal/usb_handle.h"

namespace penpose::device {

// Requests on the control pipe (USB 2.0, 9.4; HID 1.11, 7.2). A device that does not answer costs half a second.

[[nodiscard]] base::Result<std::string> get_string(const UsbHandle& usb, std::uint8_t index);

/// Of a claimed interface.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> get_report_descriptor(const UsbHandle& usb, int interface);

enum class SentReport : std::uint8_t { output = 2, feature = 3 };
/// Sends a report to a claimed interface; first byte its id, which is not sent where it is 0.
[[nodiscard]] base::Status set_report(const UsbHandle& usb, int interface, SentReport kind, base::Bytes report);
/// Asks a claimed interface for a feature report of at most that length.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> get_feature_report(const UsbHandle& usb, int interface,
                                                                         std::uint8_t id, std::size_t length);

}  // namespace penpose::device
