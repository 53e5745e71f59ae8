#pragma once

#include <cstdint>
#include <string>

#include "core/base/hidden.h"
#include "core/base/result.h"

namespace penpose::device {

/// Reads USB string descriptors of a device without touching its interfaces and their drivers. Reading some strings
/// changes the mode of some tablets, so read only those that the table of tablets names.
class UsbStrings {
 public:
  /// `usb_node`: "/dev/bus/usb/001/004". Errors: no permission to open it.
  [[nodiscard]] static base::Result<UsbStrings> open(const std::string& usb_node);

  /// In American English, which all tablets have; characters outside ASCII come as '?'. Errors: no such string.
  [[nodiscard]] base::Result<std::string> read(std::uint8_t index) const;

 private:
  class Handle;
  explicit UsbStrings(base::Hidden<Handle> handle);

  base::Hidden<Handle> handle_;
};

/// One string of a device; `usb_node` as above, empty for what is none. Errors: those of UsbStrings; not a USB device.
[[nodiscard]] base::Result<std::string> read_usb_string(const std::string& usb_node, std::uint8_t index);

}  // namespace penpose::device
