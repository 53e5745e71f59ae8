#include "replay/session/virtual_pen.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace penpose::replay {
namespace {

constexpr double k_largest_position = 65535;
constexpr double k_largest_pressure = 4095;

// HID 1.11, section 6.2.2; usages of the Digitizers page (HID Usage Tables 1.4, section 16).
constexpr std::array<std::uint8_t, 66> k_descriptor{
    0x05, 0x0d,                    // Usage Page (Digitizers)
    0x09, 0x02,                    // Usage (Pen)
    0xa1, 0x01,                    // Collection (Application)
    0x85, 0x01,                    //   Report ID (1)
    0x09, 0x20,                    //   Usage (Stylus)
    0xa1, 0x00,                    //   Collection (Physical)
    0x09, 0x32,                    //     Usage (In Range)
    0x09, 0x42,                    //     Usage (Tip Switch)
    0x09, 0x44,                    //     Usage (Barrel Switch)
    0x09, 0x3c,                    //     Usage (Invert)
    0x09, 0x45,                    //     Usage (Eraser)
    0x15, 0x00,                    //     Logical Minimum (0)
    0x25, 0x01,                    //     Logical Maximum (1)
    0x75, 0x01,                    //     Report Size (1)
    0x95, 0x05,                    //     Report Count (5)
    0x81, 0x02,                    //     Input (Data, Variable, Absolute)
    0x95, 0x03,                    //     Report Count (3)
    0x81, 0x03,                    //     Input (Constant)
    0x05, 0x01,                    //     Usage Page (Generic Desktop)
    0x27, 0xff, 0xff, 0x00, 0x00,  //     Logical Maximum (65535)
    0x75, 0x10,                    //     Report Size (16)
    0x95, 0x01,                    //     Report Count (1)
    0x09, 0x30,                    //     Usage (X)
    0x81, 0x02,                    //     Input
    0x09, 0x31,                    //     Usage (Y)
    0x81, 0x02,                    //     Input
    0x05, 0x0d,                    //     Usage Page (Digitizers)
    0x09, 0x30,                    //     Usage (Tip Pressure)
    0x26, 0xff, 0x0f,              //     Logical Maximum (4095)
    0x81, 0x02,                    //     Input
    0xc0,                          //   End Collection
    0xc0,                          // End Collection
};

std::uint16_t scaled(double value, double range, double largest) {
  const double share = range > 0 ? std::clamp(value / range, 0.0, 1.0) : 0.0;
  return static_cast<std::uint16_t>(std::floor(share * largest + 0.5));
}

}  // namespace

TraceDevice virtual_pen_device() {
  TraceDevice device;
  device.report_descriptor.assign(k_descriptor.begin(), k_descriptor.end());
  device.name = "penpose virtual pen";
  device.bus = decode::k_bus_virtual;
  return device;
}

decode::DeviceIdentity virtual_pen_identity() {
  const TraceDevice device = virtual_pen_device();
  decode::DeviceIdentity identity;
  identity.bus = device.bus;
  identity.name = device.name;
  identity.report_descriptor = device.report_descriptor;
  return identity;
}

VirtualPenReport virtual_pen_report(const VirtualPenState& state, geometry::Viewport viewport) {
  const std::uint16_t x = scaled(state.position.x, viewport.width, k_largest_position);
  const std::uint16_t y = scaled(state.position.y, viewport.height, k_largest_position);
  const bool touches = state.in_range && state.tip;
  const std::uint16_t pressure = touches ? scaled(state.pressure, 1.0, k_largest_pressure) : std::uint16_t{0};
  unsigned flags = 0;
  if (state.in_range) flags |= 1U;
  if (touches) flags |= state.eraser ? 16U : 2U;
  if (state.in_range && state.barrel) flags |= 4U;
  if (state.in_range && state.eraser) flags |= 8U;
  const auto low = [](std::uint16_t v) { return static_cast<std::uint8_t>(v & 0xffU); };
  const auto high = [](std::uint16_t v) { return static_cast<std::uint8_t>(v >> 8U); };
  return {1, static_cast<std::uint8_t>(flags), low(x), high(x), low(y), high(y), low(pressure), high(pressure)};
}

}  // namespace penpose::replay
