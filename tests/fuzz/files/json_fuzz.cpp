#include <cstdint>

#include "core/base/json/loose_json.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto json = penpose::json::parse_loose_json({data, size});
  if (!json) return 0;
  // What was read is written as text that is read to the same.
  const auto again = penpose::json::parse_json(penpose::base::as_bytes(json->dump_as_made()));
  if (!again || !(*again == *json)) __builtin_trap();
  return 0;
}
