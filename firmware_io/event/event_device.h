#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace penpose::event {

/// An event of a Linux input device. Numbers are those of input-event-codes.h.
struct Event {
  std::uint16_t type = 0, code = 0;
  std::int32_t value = 0;
};

/// The range of an absolute axis as its driver states it. `resolution` is in units per mm, of tilt and rotation in
/// units per radian; 0: unknown.
struct AbsRange {
  std::int32_t minimum = 0, maximum = 0, resolution = 0;

  [[nodiscard]] bool is_empty() const { return minimum >= maximum; }
};

/// What a Linux input device (/dev/input/eventN) says of itself.
struct EventAxes {
  std::string name;
  std::string physical;  ///< where it is plugged in
  std::uint16_t bus = 0;
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  std::map<std::uint16_t, AbsRange> abs;  ///< by code
  std::set<std::uint16_t> keys;
  std::set<std::uint16_t> rels;
  std::set<std::uint16_t> mscs;
  std::set<std::uint16_t> properties;

  [[nodiscard]] bool has_abs(std::uint16_t code) const { return abs.contains(code); }
  [[nodiscard]] bool has_key(std::uint16_t code) const { return keys.contains(code); }
};

/// A pen or a puck on a tablet. Told apart as udev does it (udev-builtin-input_id.c).
[[nodiscard]] bool has_pen(const EventAxes& axes);
/// Keys, rings, strips or wheels of a tablet.
[[nodiscard]] bool has_pad(const EventAxes& axes);
/// Fingers in slots (multi-touch protocol B).
[[nodiscard]] bool has_fingers(const EventAxes& axes);

/// The report descriptor of a HID device that has the same controls, with ranges and units, so that decoders of devices
/// that describe themselves give the same samples. Ends with hid::k_event_mark. Without a control that is known, only
/// the mark. Below 4096 bytes, as Linux asks for.
[[nodiscard]] std::vector<std::uint8_t> report_descriptor(const EventAxes& axes);

}  // namespace penpose::event
