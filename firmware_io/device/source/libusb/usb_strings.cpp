#include "firmware_io/device/source/usb_strings.h"

#include "firmware_io/device/source/libusb/internal/usb_transfers.h"

namespace penpose::device {

class UsbStrings::Handle {
 public:
  explicit Handle(UsbHandle opened) : usb(std::move(opened)) {}
  UsbHandle usb;
};

UsbStrings::UsbStrings(base::Hidden<Handle> handle) : handle_(std::move(handle)) {}

base::Result<UsbStrings> UsbStrings::open(const std::string& usb_node) {
  auto usb = UsbHandle::open(usb_node);
  if (!usb) return usb.error();
  return UsbStrings(base::make_hidden<Handle>(std::move(usb).value()));
}

base::Result<std::string> UsbStrings::read(std::uint8_t index) const { return get_string(handle_->usb, index); }

}  // namespace penpose::device
