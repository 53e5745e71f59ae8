#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "firmware_io/hid/field.h"

namespace penpose::event {

/// What a control counts in.
struct ControlUnit {
  std::uint32_t unit = 0;     ///< nibbles of HID 1.11, 6.2.2.7
  std::int64_t per_unit = 0;  ///< logical units for each of it; 0: unknown
};

/// A control of one report, in a field of its own.
struct Control {
  hid::Usage usage = 0;
  std::uint32_t bit_size = 1;
  std::int64_t minimum = 0;
  std::int64_t maximum = 1;
  std::uint32_t flags = hid::k_flag_variable;
  ControlUnit unit = {};
};

/// Writes a report descriptor item by item and counts the bits of its reports. Usages come with their page; global
/// items are written where they change.
class DescriptorWriter {
 public:
  void open(std::uint8_t collection_kind, hid::Usage usage);
  void close();
  /// What follows is of this report.
  void begin_report(std::uint8_t id);
  /// Gives the bit offset of the control in its report as received, the id byte included.
  std::uint32_t input(const Control& control);
  void feature(const Control& control);
  /// Fills the report up to a whole byte.
  void pad();
  /// Bytes of the present report so far, the id included.
  [[nodiscard]] std::size_t report_length() const { return (bits_ + 7) / 8; }
  void append(base::Bytes bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }
  [[nodiscard]] std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
  void item(std::uint8_t head, std::int64_t value, std::size_t least = 0);
  void global(std::size_t which, std::int64_t value);
  void main(std::uint8_t head, const Control& control);

  std::vector<std::uint8_t> bytes_;
  std::vector<std::optional<std::int64_t>> globals_ = std::vector<std::optional<std::int64_t>>(16);
  std::uint32_t bits_ = 0;
};

}  // namespace penpose::event
