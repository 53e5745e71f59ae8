#include "core/base/text/utf8.h"

#include <algorithm>
#include <cstdint>

namespace penpose::base {

namespace {

/// By its first byte alone.
std::size_t wanted_length(std::uint8_t first) {
  if (first < 0x80) return 1;
  if (first < 0xc2 || first > 0xf4) return 0;
  return first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
}

}  // namespace

std::size_t utf8_begun(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t first = byte(0);
  const std::size_t length = std::min(wanted_length(first), text.size());
  std::size_t begun = std::min<std::size_t>(length, 1);
  for (; begun < length; ++begun) {
    std::uint8_t least = 0x80;
    std::uint8_t most = 0xbf;
    if (begun == 1) {
      // No longer than needed, no surrogate, nothing above 0x10ffff.
      if (first == 0xe0) least = 0xa0;
      if (first == 0xed) most = 0x9f;
      if (first == 0xf0) least = 0x90;
      if (first == 0xf4) most = 0x8f;
    }
    if (byte(begun) < least || byte(begun) > most) break;
  }
  return begun;
}

std::size_t utf8_sequence_length(std::string_view text) {
  const std::size_t length = wanted_length(static_cast<std::uint8_t>(text[0]));
  return utf8_begun(text) == length ? length : 0;
}

std::string utf8_of(char32_t code) {
  const auto byte = [&](unsigned mark, unsigned shift) { return static_cast<char>(mark | (code >> shift & 0x3f)); };
  if (code < 0x80) return {static_cast<char>(code)};
  if (code < 0x800) return {byte(0xc0, 6), byte(0x80, 0)};
  if (code < 0x10000) return {static_cast<char>(0xe0 | code >> 12), byte(0x80, 6), byte(0x80, 0)};
  return {static_cast<char>(0xf0 | code >> 18), byte(0x80, 12), byte(0x80, 6), byte(0x80, 0)};
}

std::string valid_utf8(std::string_view text) {
  std::string valid;
  while (!text.empty()) {
    const std::size_t length = utf8_sequence_length(text);
    if (length == 0) {
      valid += '?';
      text.remove_prefix(1);
    } else {
      valid += text.substr(0, length);
      text.remove_prefix(length);
    }
  }
  return valid;
}

}  // namespace penpose::base
