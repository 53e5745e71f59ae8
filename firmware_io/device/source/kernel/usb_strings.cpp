#include "firmware_io/device/source/usb_strings.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fcntl.h>
#include <linux/usb/ch9.h>
#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>
#include <system_error>
#include <unistd.h>

#include "firmware_io/device/source/usb_string_text.h"

namespace penpose::device {
namespace {

base::Error system_error(const std::string& what, const std::string& place) {
  return {what + " (" + std::generic_category().message(errno) + ")", place, "`penpose devices` says what is missing"};
}

}  // namespace

class UsbStrings::Handle {
 public:
  explicit Handle(int opened) : file(opened) {}
  ~Handle() { ::close(file); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  int file;
};

UsbStrings::UsbStrings(base::Hidden<Handle> handle) : handle_(std::move(handle)) {}

base::Result<UsbStrings> UsbStrings::open(const std::string& usb_node) {
  const int file = ::open(usb_node.c_str(), O_RDWR | O_CLOEXEC);
  if (file < 0) return system_error("cannot be opened", usb_node);
  return UsbStrings(base::make_hidden<Handle>(file));
}

base::Result<std::string> UsbStrings::read(std::uint8_t index) const {
  std::array<std::uint8_t, 255> raw{};
  usbdevfs_ctrltransfer request{};
  request.bRequestType = USB_DIR_IN;
  request.bRequest = USB_REQ_GET_DESCRIPTOR;
  request.wValue = static_cast<std::uint16_t>((USB_DT_STRING << 8) | index);
  request.wIndex = language_of_string(index);
  request.wLength = static_cast<std::uint16_t>(raw.size());
  request.timeout = k_string_timeout_ms;
  request.data = raw.data();
  const int got = ::ioctl(handle_->file, USBDEVFS_CONTROL, &request);
  if (got < 0) return system_error("string " + std::to_string(index) + " cannot be read", "");
  return text_of_string(base::Bytes(raw.data(), static_cast<std::size_t>(got)), index);
}

}  // namespace penpose::device
