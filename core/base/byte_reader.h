#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace penpose::base {

using Bytes = std::span<const std::uint8_t>;

[[nodiscard]] inline std::string_view as_text(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}
[[nodiscard]] inline Bytes as_bytes(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// Reads little-endian numbers from bytes that nobody vouches for. A read past the end gives nothing and moves nothing.
class ByteReader {
 public:
  explicit ByteReader(Bytes bytes) : bytes_(bytes) {}

  [[nodiscard]] std::size_t offset() const { return offset_; }
  [[nodiscard]] std::size_t remaining() const { return bytes_.size() - offset_; }
  [[nodiscard]] bool at_end() const { return remaining() == 0; }

  /// The next `count` bytes, or nothing when fewer are left.
  std::optional<Bytes> take(std::size_t count);
  /// Moves to an absolute offset; false when it lies past the end.
  bool seek(std::size_t offset);

  /// The next unsigned integer of sizeof(T) bytes, least significant first.
  template <std::unsigned_integral T>
  std::optional<T> read() {
    const auto piece = take(sizeof(T));
    if (!piece) return std::nullopt;
    T value = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i)
      value = static_cast<T>(value | (static_cast<T>((*piece)[i]) << (8 * i)));
    return value;
  }
  std::optional<float> read_f32() {
    const auto raw = read<std::uint32_t>();
    if (!raw) return std::nullopt;
    return std::bit_cast<float>(*raw);
  }
  std::optional<double> read_f64() {
    const auto raw = read<std::uint64_t>();
    if (!raw) return std::nullopt;
    return std::bit_cast<double>(*raw);
  }

 private:
  Bytes bytes_;
  std::size_t offset_ = 0;
};

}  // namespace penpose::base
