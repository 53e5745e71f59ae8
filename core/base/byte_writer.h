#pragma once

#include <concepts>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/base/byte_reader.h"

namespace penpose::base {

/// Appends little-endian numbers and bytes to a growing buffer.
class ByteWriter {
 public:
  [[nodiscard]] const std::vector<std::uint8_t>& bytes() const { return bytes_; }
  [[nodiscard]] std::vector<std::uint8_t> take() { return std::move(bytes_); }
  [[nodiscard]] std::size_t size() const { return bytes_.size(); }

  template <std::unsigned_integral T>
  void write(T value) {
    for (std::size_t i = 0; i < sizeof(T); ++i) bytes_.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  }
  void write_f32(float value) { write(std::bit_cast<std::uint32_t>(value)); }
  void write_f64(double value) { write(std::bit_cast<std::uint64_t>(value)); }
  void append(Bytes bytes);
  void append(std::string_view text) { append(as_bytes(text)); }
  /// Fills up with `filler` until the size is a multiple of `alignment`.
  void align(std::size_t alignment, std::uint8_t filler = 0);

 private:
  std::vector<std::uint8_t> bytes_;
};

}  // namespace penpose::base
