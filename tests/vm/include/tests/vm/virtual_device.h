#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "firmware_io/decode/sample/device_identity.h"

namespace penpose::tests {

/// A tablet that exists only in this program and looks to the kernel like any other. Its interfaces are numbered as in
/// the trace that it was made from.
class VirtualDevice {
 public:
  using Interfaces = std::map<int, decode::DeviceIdentity>;
  virtual ~VirtualDevice() = default;

  /// Sends a report of an interface; waits for somebody to take it where the transport has such a wait.
  virtual base::Status send(int interface, base::Bytes report) = 0;
  /// Waits until the kernel's driver has done with the last report of an interface.
  virtual base::Status settle(int interface) {
    (void)interface;
    return base::Done{};
  }
  /// Pulls the plug.
  virtual void unplug() = 0;
};

/// Through /dev/uhid: a HID device of any bus, without USB.
[[nodiscard]] base::Result<std::unique_ptr<VirtualDevice>> make_uhid_device(
    const VirtualDevice::Interfaces& interfaces);

/// ASCII text as USB string descriptors hold it.
[[nodiscard]] std::vector<std::uint8_t> as_utf16(const std::string& text);

/// What a virtual USB device says and does beside sending reports.
struct UsbBehaviour {
  std::map<int, std::vector<std::uint8_t>> strings;  ///< USB string descriptors without their two bytes of header
  int port = 0;                                      ///< of the virtual host controller
  /// Sends no report until the string with this index was read; -1: from the start.
  int asleep_until_string = -1;
  bool takes_output = false;  ///< every interface has an endpoint for output as well
};

/// Takes one option of the programs that make a virtual USB device: "--string N=TEXT", "--bytes N=HEX" (strings),
/// "--port N", "--asleep-until N", "--output yes". False for any other.
[[nodiscard]] bool take_usb_option(UsbBehaviour& behaviour, const std::string& name, const std::string& value);

/// A USB device with one HID interface per entry, served over the USB/IP protocol to the kernel's own vhci_hcd.
[[nodiscard]] base::Result<std::unique_ptr<VirtualDevice>> make_usb_device(const VirtualDevice::Interfaces& interfaces,
                                                                           const UsbBehaviour& behaviour);

}  // namespace penpose::tests
