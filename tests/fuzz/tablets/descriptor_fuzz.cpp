// Any bytes as a report descriptor, the rest of them as a report of the device that it describes.

#include <cstdint>
#include <cstdlib>

#include "firmware_io/decode/layout/pen_layout.h"
#include "firmware_io/hid/report_descriptor.h"

using namespace penpose;

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const base::Bytes bytes(data, size);
  for (const auto strictness : {hid::Strictness::exact, hid::Strictness::tolerant}) {
    const auto parsed = hid::parse_report_descriptor(bytes, strictness);
    if (!parsed) {
      if (parsed.error().place.empty()) std::abort();
      continue;
    }
    for (const hid::Field& field : parsed->fields) {
      if (field.logical_minimum > field.logical_maximum) std::abort();
      if (field.collection >= static_cast<std::int32_t>(parsed->collections.size())) std::abort();
      for (std::uint32_t i = 0; i < field.count && i < 4; ++i) {
        (void)hid::value_of(field, bytes, i);
        (void)field.usage_of(i);
      }
      (void)hid::units_per_mm(field);
      (void)hid::units_per_degree(field);
    }
    (void)decode::find_pens(*parsed, decode::Dialect::standard);
    (void)decode::find_pens(*parsed, decode::Dialect::wacom);
  }
  return 0;
}
