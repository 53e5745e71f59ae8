#pragma once

#include <array>
#include <cstdint>

#include "core/geometry/camera.h"
#include "core/geometry/space.h"
#include "firmware_io/decode/sample/device_identity.h"
#include "replay/trace/trace_writer.h"

namespace penpose::replay {

/// What a pointer that is no tablet (mouse, finger, script) does at one moment.
struct VirtualPenState {
  geometry::PxPoint position{};
  double pressure = 1;  ///< 0..1, counts while the tip touches
  bool in_range = true;
  bool tip = false;
  bool eraser = false;
  bool barrel = false;
};

inline constexpr std::size_t k_virtual_pen_report_size = 8;
using VirtualPenReport = std::array<std::uint8_t, k_virtual_pen_report_size>;

/// The virtual pen as a trace declares it: bus "virtual", a digitizer whose descriptor any HID parser reads (in range,
/// tip, eraser, barrel switch, X and Y of 0..65535 over the whole picture, pressure 0..4095).
[[nodiscard]] TraceDevice virtual_pen_device();
[[nodiscard]] decode::DeviceIdentity virtual_pen_identity();

/// The report of a state on a picture of that size, in positions of at least a 32nd px up to 2000 px. Positions outside
/// of the picture go to its edge.
[[nodiscard]] VirtualPenReport virtual_pen_report(const VirtualPenState& state, geometry::Viewport viewport);

}  // namespace penpose::replay
