#pragma once

#include <cstdint>
#include <vector>

#include "core/base/byte_reader.h"
#include "firmware_io/hid/usages.h"

namespace penpose::hid {

enum class ReportType : std::uint8_t { input, output, feature };

/// Bits of an Input, Output or Feature item (HID 1.11, 6.2.2.5).
inline constexpr std::uint32_t k_flag_constant = 1u << 0;
inline constexpr std::uint32_t k_flag_variable = 1u << 1;
inline constexpr std::uint32_t k_flag_relative = 1u << 2;
inline constexpr std::uint32_t k_flag_wrap = 1u << 3;
inline constexpr std::uint32_t k_flag_nonlinear = 1u << 4;
inline constexpr std::uint32_t k_flag_no_preferred = 1u << 5;
inline constexpr std::uint32_t k_flag_null_state = 1u << 6;
inline constexpr std::uint32_t k_flag_volatile = 1u << 7;
inline constexpr std::uint32_t k_flag_buffered_bytes = 1u << 8;

/// Consecutive usages of one page, both ends included. `alternative` marks a usage that a delimited set offers in place
/// of the one before it; it takes up no control of its own.
struct UsageRange {
  Usage minimum = 0;
  Usage maximum = 0;
  bool alternative = false;
};

/// Consecutive designator or string indexes, both ends included.
struct IndexRange {
  std::uint32_t minimum = 0;
  std::uint32_t maximum = 0;
};

/// One Input, Output or Feature item: `count` controls of `bit_size` bits each, the first at `bit_offset` of the
/// report.
struct Field {
  ReportType type = ReportType::input;
  std::uint8_t report_id = 0;    ///< 0: the device has no report ids
  std::uint32_t bit_offset = 0;  ///< from the start of the report as received, the report id byte included
  std::uint32_t bit_size = 0;
  std::uint32_t count = 0;
  std::uint32_t flags = 0;
  std::int64_t logical_minimum = 0;  ///< signed when the declared minimum is negative, unsigned otherwise
  std::int64_t logical_maximum = 0;
  std::int64_t physical_minimum = 0;  ///< the logical range where the descriptor leaves the physical one undefined
  std::int64_t physical_maximum = 0;
  std::int32_t unit_exponent = 0;  ///< power of ten
  std::uint32_t unit = 0;          ///< nibbles of HID 1.11, 6.2.2.7
  std::int32_t collection = -1;    ///< innermost collection, -1 outside of any
  std::vector<UsageRange> usages;
  std::vector<IndexRange> designators;
  std::vector<IndexRange> strings;

  [[nodiscard]] bool is_constant() const { return (flags & k_flag_constant) != 0; }
  [[nodiscard]] bool is_variable() const { return (flags & k_flag_variable) != 0; }
  [[nodiscard]] bool is_array() const { return !is_variable(); }
  [[nodiscard]] bool is_signed() const { return logical_minimum < 0; }

  /// The usage of control `index` of a variable field, or of array selector `index`. The last usage is that of all
  /// further controls (HID 1.11, 6.2.2.8); 0 when the field has none.
  [[nodiscard]] Usage usage_of(std::uint64_t index) const;
  /// How many usages are listed, alternatives left out.
  [[nodiscard]] std::uint64_t usage_count() const;
};

/// `size` bits (0..64) from bit `offset` of the report, least significant first; bits past the end of the report are 0.
[[nodiscard]] std::uint64_t extract_unsigned(base::Bytes report, std::uint64_t offset, std::uint32_t size);
/// The same, as a two's complement number of that size.
[[nodiscard]] std::int64_t extract_signed(base::Bytes report, std::uint64_t offset, std::uint32_t size);

/// The value of control `index` of a field, sign-extended where its logical minimum is negative. Of fields wider than
/// 64 bits the lowest 64. The caller has checked that the report's id is the field's.
[[nodiscard]] std::int64_t value_of(const Field& field, base::Bytes report, std::uint32_t index = 0);

/// Units of an axis in its field's declared unit: logical units per millimetre for lengths, per degree for angles, 0
/// where the unit is missing or something else.
[[nodiscard]] double units_per_mm(const Field& field);
[[nodiscard]] double units_per_degree(const Field& field);

}  // namespace penpose::hid
