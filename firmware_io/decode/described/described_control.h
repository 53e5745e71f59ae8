#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "firmware_io/hid/report_descriptor.h"

namespace penpose::decode {

/// One control of a report, placed by its descriptor.
struct DescribedControl {
  std::uint32_t bit_offset = 0;
  std::uint32_t bit_size = 0;
  bool is_signed = false;
  std::int64_t minimum = 0;
  std::int64_t maximum = 0;

  DescribedControl() = default;
  DescribedControl(const hid::Field& field, std::uint32_t index)
      : bit_offset(field.bit_offset + index * field.bit_size),
        bit_size(std::min(field.bit_size, 32U)),
        is_signed(field.is_signed()),
        minimum(field.logical_minimum),
        maximum(field.logical_maximum) {}

  [[nodiscard]] std::int64_t value(base::Bytes report) const {
    return is_signed ? hid::extract_signed(report, bit_offset, bit_size)
                     : static_cast<std::int64_t>(hid::extract_unsigned(report, bit_offset, bit_size));
  }
  [[nodiscard]] bool holds(std::int64_t value) const { return value >= minimum && value <= maximum; }
};

/// More controls than any field of keys or fingers has; one that claims more is an opaque block.
inline constexpr std::uint64_t k_most_controls_of_field = 64;

/// The fields of a type that have usages, report by report in the order in which the descriptor first names them, as in
/// Linux.
[[nodiscard]] inline std::vector<const hid::Field*> fields_by_report(const hid::ReportDescriptor& descriptor,
                                                                     hid::ReportType type) {
  std::vector<const hid::Field*> fields;
  std::vector<std::uint8_t> ids;
  for (const hid::Field& field : descriptor.fields) {
    if (field.type == type && std::find(ids.begin(), ids.end(), field.report_id) == ids.end())
      ids.push_back(field.report_id);
  }
  for (const std::uint8_t id : ids) {
    for (const hid::Field& field : descriptor.fields) {
      if (field.type == type && field.report_id == id && !field.usages.empty()) fields.push_back(&field);
    }
  }
  return fields;
}

}  // namespace penpose::decode
