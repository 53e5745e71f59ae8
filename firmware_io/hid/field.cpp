#include "firmware_io/hid/field.h"

#include <algorithm>

#include "core/base/math.h"

namespace penpose::hid {
namespace {

enum class System : std::uint32_t { si_linear = 1, si_rotation, english_linear, english_rotation };

double ten_to_the(std::int32_t exponent) {
  double result = 1;
  for (std::int32_t i = 0; i < std::min(exponent, 300); ++i) result *= 10;
  for (std::int32_t i = 0; i > std::max(exponent, -300); --i) result /= 10;
  return result;
}

/// Logical units for each of the field's own physical units; 0 unless the unit is of `system` and nothing but a first
/// power.
double density(const Field& field, System system) {
  if (field.unit != (0x10u | static_cast<std::uint32_t>(system))) return 0;
  const auto physical = static_cast<double>(field.physical_maximum - field.physical_minimum);
  const auto logical = static_cast<double>(field.logical_maximum - field.logical_minimum);
  if (physical <= 0 || logical <= 0) return 0;
  return logical / (physical * ten_to_the(field.unit_exponent));
}

}  // namespace

Usage Field::usage_of(std::uint64_t index) const {
  Usage last = 0;
  for (const UsageRange& range : usages) {
    if (range.alternative) continue;
    const std::uint64_t size = static_cast<std::uint64_t>(range.maximum) - range.minimum + 1;
    if (index < size) return range.minimum + static_cast<Usage>(index);
    index -= size;
    last = range.maximum;
  }
  return is_variable() ? last : 0;
}

std::uint64_t Field::usage_count() const {
  std::uint64_t count_of_usages = 0;
  for (const UsageRange& range : usages) {
    if (!range.alternative) count_of_usages += static_cast<std::uint64_t>(range.maximum) - range.minimum + 1;
  }
  return count_of_usages;
}

std::uint64_t extract_unsigned(base::Bytes report, std::uint64_t offset, std::uint32_t size) {
  if (size == 0) return 0;
  size = std::min(size, 64u);
  const std::uint64_t first = offset / 8;
  const auto shift = static_cast<unsigned>(offset % 8);
  const std::uint64_t bytes = (shift + size + 7) / 8;  // up to 9
  if (first >= report.size()) return 0;
  // One look at the length for all bytes: this is the innermost loop of described tablets.
  const std::uint64_t there = std::min<std::uint64_t>(bytes, report.size() - first);
  const std::uint8_t* const from = report.data() + first;
  std::uint64_t value = 0;
  for (std::uint64_t i = 0; i < there && i < 8; ++i) value |= std::uint64_t{from[i]} << (8 * i);
  value >>= shift;
  if (there == 9) value |= std::uint64_t{from[8]} << (64 - shift);
  return size == 64 ? value : value & ((std::uint64_t{1} << size) - 1);
}

std::int64_t extract_signed(base::Bytes report, std::uint64_t offset, std::uint32_t size) {
  if (size == 0) return 0;
  size = std::min(size, 64u);
  const std::uint64_t value = extract_unsigned(report, offset, size);
  if (size == 64) return static_cast<std::int64_t>(value);
  const std::uint64_t sign = std::uint64_t{1} << (size - 1);
  return static_cast<std::int64_t>((value ^ sign) - sign);
}

std::int64_t value_of(const Field& field, base::Bytes report, std::uint32_t index) {
  const std::uint64_t offset = field.bit_offset + std::uint64_t{index} * field.bit_size;
  return field.is_signed() ? extract_signed(report, offset, field.bit_size)
                           : static_cast<std::int64_t>(extract_unsigned(report, offset, field.bit_size));
}

double units_per_mm(const Field& field) {
  if (const double per_cm = density(field, System::si_linear); per_cm > 0) return per_cm / 10;
  return density(field, System::english_linear) / 25.4;
}

double units_per_degree(const Field& field) {
  if (const double per_degree = density(field, System::english_rotation); per_degree > 0) return per_degree;
  return density(field, System::si_rotation) * (base::k_pi / 180);
}

}  // namespace penpose::hid
