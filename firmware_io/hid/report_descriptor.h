#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "firmware_io/hid/field.h"

namespace penpose::hid {

/// Kinds of collection (HID 1.11, 6.2.2.6); vendor-defined ones have values from 0x80.
inline constexpr std::uint8_t k_collection_physical = 0;
inline constexpr std::uint8_t k_collection_application = 1;
inline constexpr std::uint8_t k_collection_logical = 2;

struct Collection {
  std::uint8_t kind = 0;
  Usage usage = 0;
  std::int32_t parent = -1;  ///< index of the collection around it, -1 at the top
};

/// The reports of one interface, as described by its report descriptor.
struct ReportDescriptor {
  std::vector<Collection> collections;  ///< in order of opening
  std::vector<Field> fields;            ///< in order of appearance, padding included
  bool has_report_ids = false;

  /// Bytes of a report as received, the report id included; 0 when there is no such report.
  [[nodiscard]] std::uint32_t report_length(ReportType type, std::uint8_t report_id) const;
  /// Bytes of the longest report of a type, the report id included; 0 when there is none.
  [[nodiscard]] std::uint32_t longest_report(ReportType type) const;

  /// The usage of the innermost collection of a kind around a field, 0 when there is none.
  [[nodiscard]] Usage enclosing(const Field& field, std::uint8_t kind) const;
  /// Whether any collection around a field has this usage.
  [[nodiscard]] bool is_inside(const Field& field, Usage usage) const;

  /// Bits of data of each report by type and id, without the id byte.
  std::array<std::array<std::uint32_t, 256>, 3> report_bits{};
};

/// `tolerant` skips illegal but harmless items that real devices have, as operating systems do: reserved items, and
/// ranges with one end or with one end given twice.
enum class Strictness : std::uint8_t { exact, tolerant };

/// Parses a report descriptor of up to 64 KiB as the class specification 1.11 defines it. Memory grows with the number
/// of main items, not with the usages that a range spans. Errors name the byte offset of the item that is wrong.
[[nodiscard]] base::Result<ReportDescriptor> parse_report_descriptor(base::Bytes descriptor,
                                                                     Strictness strictness = Strictness::exact);

}  // namespace penpose::hid
