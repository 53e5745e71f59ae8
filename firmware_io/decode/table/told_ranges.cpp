#include "firmware_io/decode/table/told_ranges.h"

#include <vector>

#include "core/base/text/letters.h"

namespace penpose::decode {
namespace {

constexpr std::uint8_t k_pen_report = 8;
constexpr std::uint32_t k_pen_report_length = 12;
constexpr std::size_t k_ranges_size = 10;
/// The most that the protocol's seventeen bits hold.
constexpr std::int32_t k_largest_position = 0x1ffff;
constexpr double k_mm_per_inch = 25.4;

/// Bytes that are written in hexadecimal; none if they are not.
std::vector<std::uint8_t> bytes_of(std::string_view text) {
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i + 1 < text.size(); i += 2) {
    const auto high = base::hex_value(text[i]);
    const auto low = base::hex_value(text[i + 1]);
    if (!high || !low) return {};
    bytes.push_back(static_cast<std::uint8_t>(*high << 4 | *low));
  }
  return bytes;
}

}  // namespace

std::string ranges_text(base::Bytes utf16) {
  std::string text;
  std::string digits;
  bool is_text = true;
  for (std::size_t i = 0; i < utf16.size(); ++i) {
    base::append_hex(digits, utf16[i], 2);
    if (i % 2 != 0) {
      is_text = is_text && utf16[i] == 0;
    } else {
      is_text = is_text && utf16[i] >= 0x20 && utf16[i] < 0x7f;
      text += static_cast<char>(utf16[i]);
    }
  }
  return is_text ? text : digits;
}

std::optional<PenAxes> told_ranges(const DeviceIdentity& device, const hid::ReportDescriptor& descriptor) {
  if (device.vendor != k_vendor_huion) return std::nullopt;
  if (descriptor.report_length(hid::ReportType::input, k_pen_report) != k_pen_report_length) return std::nullopt;
  const auto told = device.strings.find(k_ranges_string);
  if (told == device.strings.end()) return std::nullopt;
  const std::vector<std::uint8_t> bytes = bytes_of(told->second);
  if (bytes.size() < k_ranges_size) return std::nullopt;
  const auto number = [&](std::size_t at, std::size_t size) {
    std::int32_t value = 0;
    for (std::size_t i = size; i-- > 0;) value = value << 8 | bytes[at + i];
    return value;
  };
  const double units_per_mm = number(8, 2) / k_mm_per_inch;
  PenAxes axes;
  axes.x = {0, number(0, 3), units_per_mm, true};
  axes.y = {0, number(3, 3), units_per_mm, true};
  axes.pressure = {0, number(6, 2), 0, true};
  const auto fits = [](const Axis& axis) { return axis.maximum > 0 && axis.maximum <= k_largest_position; };
  if (!fits(axes.x) || !fits(axes.y) || !fits(axes.pressure)) return std::nullopt;
  return axes;
}

}  // namespace penpose::decode
