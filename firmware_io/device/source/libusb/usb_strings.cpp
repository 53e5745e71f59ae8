#include "firmware_io/device/source/usb_strings.h"

#include "firmware_io/device/source/libusb/internal/usb_transfers.h"

namespace penpose::device {

class UsbStrings::Handle {
 public:
  explicit Handle(UsbHandle opened) : usb(std::move(opened)) {}
  UsbHandle usb;
};

UsbStrings::UsbStrings(std::unique_ptr<Handle> handle) : handle_(std::move(handle)) {}
UsbStrings::UsbStrings(UsbStrings&&) noexcept = default;
UsbStrings& UsbStrings::operator=(UsbStrings&&) noexcept = default;
UsbStrings::~UsbStrings() = default;

base::Result<UsbStrings> UsbStrings::open(const std::string& usb_node) {
  auto usb = UsbHandle::open(usb_node);
  if (!usb) return usb.error();
  return UsbStrings(std::make_unique<Handle>(std::move(usb).value()));
}

base::Result<std::string> UsbStrings::read(std::uint8_t index) const { return get_string(handle_->usb, index); }

}  // namespace penpose::device
