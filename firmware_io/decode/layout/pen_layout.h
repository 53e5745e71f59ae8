#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "firmware_io/decode/sample/pen_sample.h"
#include "firmware_io/hid/report_descriptor.h"

namespace penpose::decode {

/// The meaning of a control of a pen report. The controls of a report are evaluated in the order of the first five,
/// because each determines what the next one means.
enum class PenRole : std::uint8_t {
  eraser,
  invert,
  tip,
  pressure,
  in_range,
  x,
  y,
  height_down,  ///< Generic Desktop Z: grows towards the tablet
  distance,     ///< grows away from the tablet
  tilt_x,
  tilt_y,
  twist,
  wheel,
  barrel,
  barrel2,
  barrel3,
  serial,
  serial_high,
  tool_type,
  sense,         ///< near enough to be identified, maybe too far for a position
  report_valid,  ///< 0: the report's other controls are meaningless
};

/// One control of a pen report.
struct PenControl {
  PenRole role = PenRole::x;
  bool is_signed = false;
  bool null_state = false;
  std::uint32_t bit_offset = 0;
  std::uint32_t bit_size = 0;
  std::int64_t minimum = 0;
  std::int64_t maximum = 0;
  std::int32_t collection = -1;
  /// Where its own range lies in the device's, units of the latter; equal: they are one.
  std::int64_t to_minimum = 0, to_maximum = 0;

  /// Makes `scaled` lead from a report's range to the device's.
  void lead_to(const Axis& own, const Axis& device) {
    constexpr std::int64_t k_most = std::int64_t{1} << 30;
    const std::int64_t span = std::int64_t{own.maximum} - own.minimum;
    const std::int64_t to = std::int64_t{device.maximum} - device.minimum;
    const bool same = own.minimum == device.minimum && own.maximum == device.maximum;
    if (same || span <= 0 || to <= 0 || span > k_most || to > k_most || minimum != own.minimum) return;
    to_minimum = device.minimum;
    to_maximum = device.maximum;
  }
  /// A value of its range in the device's, rounded to the nearest unit.
  [[nodiscard]] std::int64_t scaled(std::int64_t value) const {
    return to_minimum == to_maximum ? value : rescaled(value);
  }
  /// The same where the ranges differ; kept apart, because that is rare.
  [[nodiscard]] std::int64_t rescaled(std::int64_t value) const;
  /// Its value in a report that reaches at least to its end, as `PenLayout::find` makes sure. Defined inline because
  /// decoders spend their time here; at most 32 bits. Both loops end at the report's end, so that bytes need no further
  /// bounds checks and eight of them become one load.
  [[nodiscard]] std::int64_t value(base::Bytes report) const {
    const std::size_t first = bit_offset / 8;
    const unsigned shift = bit_offset % 8;
    const std::uint8_t* const bytes = report.data();
    std::uint64_t word = 0;
    if (first + 8 <= report.size()) {
      for (std::size_t i = 0; i < 8; ++i) word |= std::uint64_t{bytes[first + i]} << (8 * i);
    } else {
      for (std::size_t i = first; i < report.size(); ++i) word |= std::uint64_t{bytes[i]} << (8 * (i - first));
    }
    word = (word >> shift) & ((std::uint64_t{1} << bit_size) - 1);
    if (!is_signed) return static_cast<std::int64_t>(word);
    const std::uint64_t sign = std::uint64_t{1} << (bit_size - 1);
    return static_cast<std::int64_t>((word ^ sign) - sign);
  }
};

/// An input report with a pen. Reports of one tablet may differ in all of this: the Windows Ink form of Wacom's tablets
/// has half the resolution of their own.
struct PenReport {
  std::uint8_t id = 0;
  std::uint32_t length = 0;  ///< bytes as described, id included
  std::uint32_t needed = 0;  ///< bytes up to the last control of the pen
  bool is_puck = false;      ///< the tool is a mouse on the tablet
  bool has_tip = false;
  bool has_invert = false;
  bool has_proximity = false;  ///< has a control for whether the pen is near
  bool has_sense = false;      ///< has a control of its own for a pen that is too far for a position
  bool has_serial = false;
  bool has_twist = false;
  bool both_are_third = false;       ///< both barrel switches at once mean a third button
  PenAxes axes;                      ///< its own ranges
  std::vector<PenControl> controls;  ///< in order of the descriptor
};

/// How to interpret the usages of a descriptor.
enum class Dialect : std::uint8_t {
  standard,  ///< Digitizer page as the HID Usage Tables define it
  wacom,     ///< the same and Wacom's vendor pages 0xff0d and 0xff00, with Wacom's nesting of collections
};

/// The pen reports of an interface.
struct PenLayout {
  bool has_report_ids = false;
  bool aes = false;  ///< serial numbers laid out as on Wacom's active electrostatic pens
  std::vector<PenReport> reports;
  std::array<std::int16_t, 256> report_of_id{};  ///< index into `reports`, -1 for ids without a pen
  PenAxes axes;  ///< the device's: those of its finest report, with what others have besides

  /// The layout of a raw report with a described pen that is long enough; null otherwise.
  [[nodiscard]] const PenReport* find(base::Bytes report) const {
    if (report.empty()) return nullptr;
    const std::int16_t index = report_of_id[has_report_ids ? report[0] : 0];
    if (index < 0) return nullptr;
    const PenReport& found = reports[static_cast<std::size_t>(index)];
    return report.size() >= found.needed ? &found : nullptr;
  }
};

/// Finds the pens of a descriptor; nothing when it describes none (a mouse, a touch screen, an opaque vendor block).
[[nodiscard]] std::optional<PenLayout> find_pens(const hid::ReportDescriptor& descriptor, Dialect dialect);

}  // namespace penpose::decode
