#pragma once

#include <cstdint>

#include "firmware_io/decode/sample/device_identity.h"
#include "tests/support/hands/pen_reports.h"

// A Wacom Intuos Pro S as it is without a descriptor: seven keys, of which the first is in the middle of the ring.
namespace penpose::tests {

inline decode::DeviceIdentity intuos_pro() {
  decode::DeviceIdentity identity;
  identity.vendor = 0x056a;
  identity.product = 0x0314;
  identity.name = "Wacom Intuos Pro S";
  return identity;
}

/// A report of its keys (bit i: key i, the middle one is 0) and of its ring (-1: nothing touches).
inline Report pad_report(unsigned keys, int ring = -1) {
  Report report(10);
  report[0] = 0x03;
  report[2] = static_cast<std::uint8_t>(ring < 0 ? 0 : 0x80 | ring);
  report[3] = static_cast<std::uint8_t>(keys & 1);
  report[4] = static_cast<std::uint8_t>(keys >> 1);
  return report;
}

}  // namespace penpose::tests
