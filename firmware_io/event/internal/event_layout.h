#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "firmware_io/event/event_device.h"

namespace penpose::event {

/// Where a control's value comes from.
enum class From : std::uint8_t {
  state,      ///< the last value of an event's type and code
  number,     ///< the same without a sign
  near,       ///< whether a tool is in range
  eraser,     ///< the eraser is in range
  pen_touch,  ///< BTN_TOUCH while the eraser is not in range
  erase,      ///< BTN_TOUCH while it is
  on_ring,    ///< a finger is on the pad's ring
};

/// A control of a report.
struct PlacedControl {
  From from = From::state;
  std::uint16_t type = 0;
  std::uint16_t code = 0;
  std::uint32_t bit_offset = 0;
  std::uint32_t bit_size = 0;
  std::int64_t minimum = 0;  ///< what the bits can hold
  std::int64_t maximum = 0;
};

struct PlacedReport {
  std::uint8_t id = 0;
  std::size_t length = 0;  ///< bytes, the id included; 0: the device has no such report
  std::vector<PlacedControl> controls;
};

/// Where a finger's values lie.
struct PlacedFinger {
  PlacedControl tip, id, x, y;
};

/// The reports of an event device and the descriptor that says so.
struct EventLayout {
  std::vector<std::uint8_t> descriptor;
  PlacedReport pen, puck, pad, touch;
  std::vector<PlacedFinger> fingers;
  PlacedControl finger_count;
  std::size_t slots = 0;                             ///< of the device, those that have no room in the report included
  std::vector<std::uint16_t> pen_tools, puck_tools;  ///< keys of the tools that it has
};

[[nodiscard]] EventLayout make_event_layout(const EventAxes& axes);

}  // namespace penpose::event
