// In place of ../libusb where the program is built without libusb and hidapi (PENPOSE_LIBUSB=OFF), which both ask for
// libudev: the kernel's own interfaces alone. They are enough for all tablets that have a hidraw node.

#include "firmware_io/device/source/built_in.h"

#include "firmware_io/device/source/libusb_source.h"

namespace penpose::device {

bool reads_through(Transport transport) { return transport != Transport::libusb; }

base::Result<std::unique_ptr<ReportSource>> open_libusb(HidInterface& interface) {
  return base::Error{"is read through libusb alone, which this penpose was built without", interface.usb_name,
                     "build it with PENPOSE_LIBUSB=ON"};
}

}  // namespace penpose::device
