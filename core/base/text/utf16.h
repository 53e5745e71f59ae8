#pragma once

#include <cstddef>

namespace penpose::base {

// Code points of UTF-16 (RFC 2781), where those above 0xffff are pairs of halves.

[[nodiscard]] constexpr bool is_high_half(char32_t unit) { return unit >= 0xd800 && unit < 0xdc00; }
[[nodiscard]] constexpr bool is_low_half(char32_t unit) { return unit >= 0xdc00 && unit < 0xe000; }
[[nodiscard]] constexpr char32_t code_of_halves(char32_t high, char32_t low) {
  return 0x10000 + ((high - 0xd800) << 10) + (low - 0xdc00);
}

/// A code point and the number of units that it takes, 1 or 2.
struct Utf16Point {
  char32_t code = 0;
  std::size_t units = 1;
};

/// The code point that a text begins with; U+FFFD for half of a pair that stands alone. `second`: the unit behind the
/// first, 0 where there is none.
[[nodiscard]] constexpr Utf16Point utf16_point(char32_t first, char32_t second) {
  if (is_high_half(first) && is_low_half(second)) return {code_of_halves(first, second), 2};
  constexpr char32_t k_replacement = 0xfffd;
  return {is_high_half(first) || is_low_half(first) ? k_replacement : first, 1};
}

}  // namespace penpose::base
