#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/byte_reader.h"

namespace penpose::decode {

// Numbers at fixed places of a report. The caller has checked the report's length.

[[nodiscard]] inline std::int32_t u8(base::Bytes report, std::size_t at) { return report[at]; }
[[nodiscard]] inline std::int32_t s8(base::Bytes report, std::size_t at) {
  return static_cast<std::int8_t>(report[at]);
}
[[nodiscard]] inline std::int32_t le16(base::Bytes report, std::size_t at) {
  return report[at] | (report[at + 1] << 8);
}
[[nodiscard]] inline std::int32_t be16(base::Bytes report, std::size_t at) {
  return (report[at] << 8) | report[at + 1];
}
[[nodiscard]] inline std::uint64_t le64(base::Bytes report, std::size_t at) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < 8; ++i) value |= static_cast<std::uint64_t>(report[at + i]) << (8 * i);
  return value;
}
[[nodiscard]] inline bool bit(base::Bytes report, std::size_t at, std::uint8_t mask) {
  return (report[at] & mask) != 0;
}

}  // namespace penpose::decode
