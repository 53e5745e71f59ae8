#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "firmware_io/decode/sample/device_identity.h"
#include "firmware_io/decode/sample/pen_sample.h"

// Writes reports from samples, the way tablets do: what the decoders are tested against.
namespace penpose::tests {

using Report = std::vector<std::uint8_t>;

inline decode::DeviceIdentity device(std::uint16_t vendor, std::uint16_t product, Report descriptor = {}) {
  decode::DeviceIdentity identity;
  identity.vendor = vendor;
  identity.product = product;
  identity.report_descriptor = std::move(descriptor);
  return identity;
}

inline std::uint8_t low(std::int32_t value) { return static_cast<std::uint8_t>(value & 0xff); }
inline std::uint8_t high(std::int32_t value) { return static_cast<std::uint8_t>((value >> 8) & 0xff); }

/// The report with which an Intuos announces a tool.
inline Report intuos_enter(std::uint32_t number, std::uint32_t serial) {
  Report report(10);
  report[0] = 0x02;
  report[1] = 0xc2;
  report[2] = static_cast<std::uint8_t>((number >> 4) & 0xff);
  report[3] = static_cast<std::uint8_t>(((number & 0xf) << 4) | (serial >> 28));
  report[4] = static_cast<std::uint8_t>(serial >> 20);
  report[5] = static_cast<std::uint8_t>(serial >> 12);
  report[6] = static_cast<std::uint8_t>(serial >> 4);
  report[7] = static_cast<std::uint8_t>(((serial & 0xf) << 4) | ((number >> 16) & 0xf));
  report[8] = static_cast<std::uint8_t>((number >> 8) & 0xf0);
  return report;
}

inline Report intuos_leave() { return {0x02, 0x80, 0, 0, 0, 0, 0, 0, 0, 0}; }

/// A pen packet of Intuos3 and later with eleven bits of pressure.
inline Report intuos_pen(const decode::PenSample& sample) {
  Report report(10);
  const std::int32_t tilt_x = sample.tilt_x + 64;
  const std::int32_t tilt_y = sample.tilt_y + 64;
  report[0] = 0x02;
  report[1] = static_cast<std::uint8_t>(0xe0 | ((sample.buttons & 3) << 1) | (sample.pressure & 1));
  report[2] = high(sample.x >> 1);
  report[3] = low(sample.x >> 1);
  report[4] = high(sample.y >> 1);
  report[5] = low(sample.y >> 1);
  report[6] = low(sample.pressure >> 3);
  report[7] = static_cast<std::uint8_t>(((sample.pressure & 6) << 5) | (tilt_x >> 1));
  report[8] = static_cast<std::uint8_t>(((tilt_x & 1) << 7) | tilt_y);
  report[9] = static_cast<std::uint8_t>((sample.distance << 2) | ((sample.x & 1) << 1) | (sample.y & 1));
  return report;
}

inline Report bamboo_pen(const decode::PenSample& sample) {
  const std::uint8_t state = sample.in_range
                                 ? static_cast<std::uint8_t>(0xe0 | (sample.tool == decode::Tool::eraser ? 8 : 0) |
                                                             (sample.buttons << 1) | (sample.tip ? 1 : 0))
                                 : 0;
  return {0x02,          state,          low(sample.x),        high(sample.x),
          low(sample.y), high(sample.y), low(sample.pressure), high(sample.pressure),
          0x20};
}

inline Report graphire_pen(const decode::PenSample& sample) {
  const std::uint8_t state =
      static_cast<std::uint8_t>((sample.in_range ? 0x90 : 0x10) | (sample.tool == decode::Tool::eraser ? 0x20 : 0) |
                                (sample.buttons << 1) | (sample.tip ? 1 : 0));
  return {0x02,          state,          low(sample.x),        high(sample.x),
          low(sample.y), high(sample.y), low(sample.pressure), static_cast<std::uint8_t>(high(sample.pressure) & 3)};
}

inline Report dtus_pen(const decode::PenSample& sample) {
  const std::uint8_t state =
      static_cast<std::uint8_t>((sample.in_range ? 0x80 : 0) | (sample.tool == decode::Tool::eraser ? 0x08 : 0x10) |
                                ((sample.buttons & 1) << 5) | (high(sample.pressure) & 3));
  return {0x11, state, low(sample.pressure), high(sample.x), low(sample.x), high(sample.y), low(sample.y), 0, 0, 0, 0};
}

inline Report tablet_pc_pen(const decode::PenSample& sample) {
  const bool eraser = sample.tool == decode::Tool::eraser;
  const std::uint8_t state =
      static_cast<std::uint8_t>((sample.in_range ? 0x20 : 0) | (eraser ? 0x08 : 0) | ((sample.buttons & 1) << 1) |
                                (sample.tip ? (eraser ? 0x04 : 0x01) : 0));
  return {0x02,          state,          low(sample.x),        high(sample.x),
          low(sample.y), high(sample.y), low(sample.pressure), high(sample.pressure)};
}

/// A Windows Ink pen: tip, barrel, eraser, invert and in-range bits, 16-bit position (hundredths of a millimetre),
/// pressure and tilt in hundredths of a degree. Report id 7.
inline Report ink_descriptor() {
  return {0x05, 0x0d, 0x09, 0x02, 0xa1, 0x01, 0x85, 0x07, 0x09, 0x20, 0xa1, 0x00,              // Pen, Stylus
          0x09, 0x42, 0x09, 0x44, 0x09, 0x45, 0x09, 0x3c, 0x09, 0x32,                          // five switches
          0x15, 0x00, 0x25, 0x01, 0x75, 0x01, 0x95, 0x05, 0x81, 0x02, 0x95, 0x03, 0x81, 0x03,  //
          0x05, 0x01, 0x55, 0x0e, 0x65, 0x11, 0x75, 0x10, 0x95, 0x01, 0xa4,                    // cm, 10^-2
          0x09, 0x30, 0x35, 0x00, 0x46, 0x7c, 0x09, 0x26, 0x7c, 0x5e, 0x81, 0x02,              // X: 24188 = 24.28 cm
          0x09, 0x31, 0x46, 0x00, 0x06, 0x26, 0x00, 0x3c, 0x81, 0x02, 0xb4,                    // Y: 15360 = 15.36 cm
          0x05, 0x0d, 0x09, 0x30, 0x26, 0xff, 0x0f, 0x81, 0x02,                                // pressure 0..4095
          0x65, 0x14, 0x55, 0x00, 0x16, 0xd8, 0xdc, 0x26, 0x28, 0x23,                          // -9000..9000
          0x35, 0xa6, 0x45, 0x5a, 0x09, 0x3d, 0x09, 0x3e, 0x95, 0x02, 0x81, 0x02,              // -90..90 degrees
          0xc0, 0xc0};
}

/// A pen that describes itself so, which is in no table.
inline decode::DeviceIdentity ink_device(std::uint16_t product, std::string name) {
  decode::DeviceIdentity identity = device(0x1b96, product, ink_descriptor());
  identity.name = std::move(name);
  return identity;
}

inline Report ink_pen(const decode::PenSample& sample) {
  const bool eraser = sample.tool == decode::Tool::eraser;
  const std::uint8_t state = static_cast<std::uint8_t>(
      (sample.tip && !eraser ? 1 : 0) | ((sample.buttons & 1) << 1) | (sample.tip && eraser ? 4 : 0) |
      (sample.in_range && eraser ? 8 : 0) | (sample.in_range ? 16 : 0));
  return {0x07,
          state,
          low(sample.x),
          high(sample.x),
          low(sample.y),
          high(sample.y),
          low(sample.pressure),
          high(sample.pressure),
          low(sample.tilt_x),
          high(sample.tilt_x),
          low(sample.tilt_y),
          high(sample.tilt_y)};
}

}  // namespace penpose::tests
