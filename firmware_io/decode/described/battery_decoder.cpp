#include "firmware_io/decode/described/battery_decoder.h"

#include <algorithm>

#include "firmware_io/hid/usages.h"

namespace penpose::decode {
namespace {

// HID Usage Tables 1.12, section 9, and Usage Tables for HID Power Devices 1.0, section 4.2.
constexpr hid::Usage k_strength = hid::usage(0x06, 0x20);
constexpr hid::Usage k_relative_charge = hid::usage(0x85, 0x64);
constexpr hid::Usage k_absolute_charge = hid::usage(0x85, 0x65);

bool is_charge(hid::Usage usage) {
  return usage == k_strength || usage == k_relative_charge || usage == k_absolute_charge;
}

}  // namespace

std::optional<BatteryLayout> find_battery(const hid::ReportDescriptor& descriptor) {
  for (const hid::Field& field : descriptor.fields) {
    const bool readable = field.is_variable() && field.bit_size > 0 && field.bit_size <= 32;
    if (field.type != hid::ReportType::input || !readable) continue;
    if (descriptor.is_inside(field, hid::k_stylus)) continue;
    for (std::uint32_t i = 0; i < std::min<std::uint64_t>(field.count, k_most_controls_of_field); ++i) {
      if (!is_charge(field.usage_of(i)) || field.logical_maximum <= field.logical_minimum) continue;
      return BatteryLayout{descriptor.has_report_ids, field.report_id,
                           descriptor.report_length(hid::ReportType::input, field.report_id),
                           DescribedControl(field, i)};
    }
  }
  return std::nullopt;
}

bool BatteryDecoder::decode(base::Bytes report) {
  const std::uint8_t id = layout_.has_report_ids && !report.empty() ? report[0] : 0;
  if (report.empty() || id != layout_.report_id || report.size() < layout_.report_length) return false;
  const std::int64_t value = layout_.charge.value(report);
  if (!layout_.charge.holds(value)) return false;
  const std::int64_t range = layout_.charge.maximum - layout_.charge.minimum;
  battery_.percent = static_cast<std::int8_t>((value - layout_.charge.minimum) * 100 / range);
  return false;
}

}  // namespace penpose::decode
