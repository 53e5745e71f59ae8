// In place of the other rooms where the program is built to read no tablets (PENPOSE_DEVICES=OFF): files alone.

#include "firmware_io/device/source/built_in.h"
#include "firmware_io/device/source/event_source.h"
#include "firmware_io/device/source/hidraw_source.h"
#include "firmware_io/device/source/libusb_source.h"
#include "firmware_io/device/source/usb_strings.h"

namespace penpose::device {
namespace {

base::Error not_built_in() {
  return {"cannot be read: this penpose was built without tablets", "", "build it with PENPOSE_DEVICES=ON"};
}

}  // namespace

class UsbStrings::Handle {};

UsbStrings::UsbStrings(base::Hidden<Handle> handle) : handle_(std::move(handle)) {}

base::Result<UsbStrings> UsbStrings::open(const std::string&) { return not_built_in(); }
base::Result<std::string> UsbStrings::read(std::uint8_t) const { return not_built_in(); }

bool reads_through(Transport) { return false; }
base::Result<std::unique_ptr<ReportSource>> open_hidraw(const HidInterface&) { return not_built_in(); }
base::Result<std::unique_ptr<ReportSource>> open_libusb(HidInterface&) { return not_built_in(); }
base::Result<std::unique_ptr<ReportSource>> open_event_device(HidInterface&) { return not_built_in(); }

}  // namespace penpose::device
