#pragma once

#include <libusb-1.0/libusb.h>
#include <memory>
#include <string>
#include <utility>

#include "core/base/result.h"

namespace penpose::device {

/// One USB device, opened by its node and nothing else: libusb neither looks for devices nor starts a thread.
class UsbHandle {
 public:
  [[nodiscard]] static base::Result<UsbHandle> open(const std::string& node);

  [[nodiscard]] libusb_device_handle* get() const { return handle_.get(); }
  [[nodiscard]] libusb_context* context() const { return context_.get(); }

 private:
  struct Exit {
    void operator()(libusb_context* context) const { libusb_exit(context); }
  };
  struct CloseFile {
    explicit CloseFile(int opened = -1) : file(opened) {}
    CloseFile(CloseFile&& other) noexcept : file(std::exchange(other.file, -1)) {}
    CloseFile& operator=(CloseFile&& other) noexcept {
      std::swap(file, other.file);
      return *this;
    }
    ~CloseFile();
    int file;
  };
  struct Close {
    void operator()(libusb_device_handle* handle) const { libusb_close(handle); }
  };

  UsbHandle() = default;

  // In order of opening; closed in the opposite one.
  CloseFile file_;
  std::unique_ptr<libusb_context, Exit> context_;
  std::unique_ptr<libusb_device_handle, Close> handle_;
};

/// "cannot do WHAT (reason)" of a libusb error.
[[nodiscard]] base::Error usb_error(const std::string& what, int code);

}  // namespace penpose::device
