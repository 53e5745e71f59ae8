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

std::optional<std::int8_t> charge_in(const BatteryLayout& layout, base::Bytes report) {
  const std::uint8_t id = layout.has_report_ids && !report.empty() ? report[0] : 0;
  if (report.empty() || id != layout.report_id || report.size() < layout.report_length) return std::nullopt;
  const std::int64_t value = layout.charge.value(report);
  if (!layout.charge.holds(value)) return std::nullopt;
  const std::int64_t range = layout.charge.maximum - layout.charge.minimum;
  return static_cast<std::int8_t>((value - layout.charge.minimum) * 100 / range);
}

bool BatteryDecoder::decode(base::Bytes report) {
  if (const auto percent = charge_in(layout_, report)) battery_.percent = *percent;
  return false;
}

}  // namespace penpose::decode
