#pragma once

#include <linux/input-event-codes.h>
#include <map>
#include <vector>

#include "firmware_io/decode/sample/device_identity.h"
#include "firmware_io/decode/sample/pen_sample.h"
#include "firmware_io/event/event_device.h"
#include "firmware_io/event/event_encoder.h"

// Linux input devices and what they send, the way the kernel does it.
namespace penpose::tests {

/// The pen of `ink_descriptor` (pen_reports.h) as Linux's hid-input makes an input device of it.
inline event::EventAxes ink_event_device() {
  event::EventAxes axes;
  axes.name = "Ink pen";
  axes.bus = decode::k_bus_usb;
  axes.vendor = 0x1b96;
  axes.product = 0x0021;
  axes.abs[ABS_X] = {0, 24188, 100};
  axes.abs[ABS_Y] = {0, 15360, 100};
  axes.abs[ABS_PRESSURE] = {0, 4095, 0};
  axes.abs[ABS_TILT_X] = {-9000, 9000, 5730};
  axes.abs[ABS_TILT_Y] = {-9000, 9000, 5730};
  axes.keys = {BTN_TOOL_PEN, BTN_TOOL_RUBBER, BTN_TOUCH, BTN_STYLUS};
  return axes;
}

inline decode::DeviceIdentity identity_of(const event::EventAxes& axes) {
  decode::DeviceIdentity identity;
  identity.bus = axes.bus;
  identity.vendor = axes.vendor;
  identity.product = axes.product;
  identity.name = axes.name;
  identity.report_descriptor = event::report_descriptor(axes);
  return identity;
}

/// Sends states as the kernel does: of axes and keys only what is new, and an end of the frame if anything was.
class InputDevice {
 public:
  explicit InputDevice(const event::EventAxes& axes) : encoder_(axes) {}

  void put(std::uint16_t type, std::uint16_t code, std::int32_t value) {
    const auto [place, is_new] = values_.try_emplace({type, code}, 0);
    const bool counts = type == EV_MSC || type == EV_REL || (type == EV_ABS && code == ABS_MT_SLOT);
    if (!counts && place->second == value) return;
    place->second = value;
    send(type, code, value);
  }
  /// Without that look at what is new; values of fingers, say.
  void send(std::uint16_t type, std::uint16_t code, std::int32_t value) {
    static_cast<void>(encoder_.take({type, code, value}));
    any_ = true;
  }
  /// The reports of the frame that ends here.
  event::EventEncoder::Reports end() {
    if (!any_) return {};
    any_ = false;
    const auto reports = encoder_.take({EV_SYN, SYN_REPORT, 0});
    return {reports.begin(), reports.end()};
  }
  /// A pen's state as hid-input passes it on.
  event::EventEncoder::Reports pen(const decode::PenSample& sample) {
    const bool eraser = sample.tool == decode::Tool::eraser;
    put(EV_ABS, ABS_X, sample.x);
    put(EV_ABS, ABS_Y, sample.y);
    put(EV_ABS, ABS_PRESSURE, sample.pressure);
    put(EV_ABS, ABS_TILT_X, sample.tilt_x);
    put(EV_ABS, ABS_TILT_Y, sample.tilt_y);
    put(EV_KEY, BTN_TOUCH, sample.tip ? 1 : 0);
    put(EV_KEY, BTN_STYLUS, sample.buttons & 1 ? 1 : 0);
    put(EV_KEY, BTN_STYLUS2, sample.buttons & 2 ? 1 : 0);
    put(EV_KEY, BTN_TOOL_RUBBER, sample.in_range && eraser ? 1 : 0);
    put(EV_KEY, BTN_TOOL_PEN, sample.in_range && !eraser ? 1 : 0);
    return end();
  }

  event::EventEncoder& encoder() { return encoder_; }

 private:
  event::EventEncoder encoder_;
  std::map<std::pair<std::uint16_t, std::uint16_t>, std::int32_t> values_;
  bool any_ = false;
};

}  // namespace penpose::tests
