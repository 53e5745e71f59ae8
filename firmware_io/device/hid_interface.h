#pragma once

#include <cstdint>
#include <string>

#include "firmware_io/decode/sample/device_identity.h"

namespace penpose::device {

/// A connected HID interface, or an input device of the kernel in its place, as reported by the system.
struct HidInterface {
  decode::DeviceIdentity identity;
  std::string hidraw_node;      ///< "/dev/hidraw3"; empty if the system made none
  std::string event_node;       ///< "/dev/input/event5" of an input device, which has no other node; empty otherwise
  std::uint64_t node_made = 0;  ///< distinguishes a node from an earlier one of the same name
  std::string usb_node;         ///< "/dev/bus/usb/001/004"; empty if it is not a USB device
  std::string usb_name;         ///< of a USB interface: "1-2:1.0"
  std::string physical;         ///< where it is plugged in
  std::string driver;           ///< of the kernel: "wacom", "hid-generic", "usbfs" (a program has it); empty where none
  std::string hid_name;         ///< of the kernel's HID device, new each time a driver is bound: "0003:056A:00B8.0002"
  std::string parent;           ///< the same for all interfaces of one device, and while it is plugged in
  bool made_by_program = false;  ///< an input device without hardware (uinput)

  /// `physical` as in a trace: for USB interfaces it ends in "/inputN", the interface's number.
  [[nodiscard]] std::string trace_path() const {
    if (usb_name.empty() || !identity.interface_number) return physical;
    const std::string end = "/input" + std::to_string(*identity.interface_number);
    return physical.find("/input") != std::string::npos ? physical : physical + end;
  }
};

}  // namespace penpose::device
