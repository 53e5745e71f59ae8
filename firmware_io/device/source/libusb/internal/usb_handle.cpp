#include "firmware_io/device/source/libusb/internal/usb_handle.h"

#include <cerrno>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>

namespace penpose::device {

UsbHandle::CloseFile::~CloseFile() {
  if (file >= 0) ::close(file);
}

base::Result<UsbHandle> UsbHandle::open(const std::string& node) {
  UsbHandle made;
  made.file_ = CloseFile(::open(node.c_str(), O_RDWR | O_CLOEXEC));
  if (made.file_.file < 0) {
    return base::Error{"cannot be opened (" + std::generic_category().message(errno) + ")", node,
                       "`penpose devices` says what is missing"};
  }
  // Holds for all contexts of the process from here on; it has no others.
  libusb_set_option(nullptr, LIBUSB_OPTION_NO_DEVICE_DISCOVERY);
  libusb_context* context = nullptr;
  if (const int code = libusb_init(&context); code != 0) return usb_error("libusb does not start", code);
  made.context_.reset(context);
  libusb_device_handle* handle = nullptr;
  if (const int code = libusb_wrap_sys_device(context, made.file_.file, &handle); code != 0) {
    return usb_error("cannot be opened", code);
  }
  made.handle_.reset(handle);
  return made;
}

base::Error usb_error(const std::string& what, int code) {
  return {what + " (" + libusb_error_name(code) + ")", "", "plug it in again"};
}

}  // namespace penpose::device
