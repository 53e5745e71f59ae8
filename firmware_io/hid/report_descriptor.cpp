#include "firmware_io/hid/report_descriptor.h"

#include <algorithm>

namespace penpose::hid {

std::uint32_t ReportDescriptor::report_length(ReportType type, std::uint8_t report_id) const {
  const std::uint32_t bits = report_bits[static_cast<std::size_t>(type)][report_id];
  if (bits == 0) return 0;
  return (bits + 7) / 8 + (has_report_ids ? 1 : 0);
}

std::uint32_t ReportDescriptor::longest_report(ReportType type) const {
  const auto& bits = report_bits[static_cast<std::size_t>(type)];
  const std::uint32_t longest = *std::max_element(bits.begin(), bits.end());
  return longest == 0 ? 0 : (longest + 7) / 8 + (has_report_ids ? 1 : 0);
}

Usage ReportDescriptor::enclosing(const Field& field, std::uint8_t kind) const {
  for (std::int32_t i = field.collection; i >= 0; i = collections[static_cast<std::size_t>(i)].parent) {
    const Collection& collection = collections[static_cast<std::size_t>(i)];
    if (collection.kind == kind) return collection.usage;
  }
  return 0;
}

bool ReportDescriptor::is_inside(const Field& field, Usage usage) const {
  for (std::int32_t i = field.collection; i >= 0; i = collections[static_cast<std::size_t>(i)].parent) {
    if (collections[static_cast<std::size_t>(i)].usage == usage) return true;
  }
  return false;
}

}  // namespace penpose::hid
