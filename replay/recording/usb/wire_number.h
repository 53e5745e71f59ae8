#pragma once

#include <cstdint>

#include "core/base/byte_reader.h"

namespace penpose::replay {

/// The unsigned number in bytes[at, at + size), with its highest or its lowest byte first. Bytes beyond the end count
/// as 0. `size` is at most 8.
[[nodiscard]] inline std::uint64_t wire_number(base::Bytes bytes, std::size_t at, std::size_t size, bool high_first) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t place = at + (high_first ? i : size - 1 - i);
    value = value << 8 | (place < bytes.size() ? bytes[place] : 0);
  }
  return value;
}

}  // namespace penpose::replay
