#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace penpose::base {

/// Latin letters of ASCII alone; all other bytes stay. No locale has a say.
[[nodiscard]] constexpr char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
[[nodiscard]] constexpr char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
[[nodiscard]] std::string lower_case(std::string_view text);
/// Whether two texts are the same but for the case of their letters.
[[nodiscard]] bool same_but_case(std::string_view a, std::string_view b);

/// The value of a hexadecimal digit, in either case.
[[nodiscard]] constexpr std::optional<unsigned> hex_value(char c) {
  if (c >= '0' && c <= '9') return static_cast<unsigned>(c - '0');
  const char letter = lower(c);
  if (letter >= 'a' && letter <= 'f') return static_cast<unsigned>(letter - 'a' + 10);
  return std::nullopt;
}
/// Appends the lowest `digits` hexadecimal digits of a value, 1 to 16.
enum class HexCase : bool { lower, upper };
void append_hex(std::string& out, std::uint64_t value, std::size_t digits, HexCase letters = HexCase::lower);

/// The text without the byte order mark that some programs put in front of UTF-8.
[[nodiscard]] std::string_view without_mark(std::string_view text);

}  // namespace penpose::base
