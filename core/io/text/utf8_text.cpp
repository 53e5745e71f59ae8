#include "core/io/text/utf8_text.h"

#include <algorithm>

#include "core/base/text/utf16.h"
#include "core/base/text/utf8.h"

namespace penpose::io {

std::optional<std::string> text_of_utf16(base::Bytes bytes) {
  if (bytes.size() < 2) return std::nullopt;
  const bool little = bytes[0] == 0xff && bytes[1] == 0xfe;
  const bool big = bytes[0] == 0xfe && bytes[1] == 0xff;
  if (!little && !big) return std::nullopt;
  const auto unit = [&](std::size_t at) -> char32_t {
    if (at + 1 >= bytes.size()) return 0;
    return little ? static_cast<char32_t>(bytes[at] | bytes[at + 1] << 8)
                  : static_cast<char32_t>(bytes[at] << 8 | bytes[at + 1]);
  };
  std::string text;
  text.reserve(bytes.size());
  for (std::size_t at = 2; at + 1 < bytes.size();) {
    const base::Utf16Point point = base::utf16_point(unit(at), unit(at + 2));
    text += base::utf8_of(point.code);
    at += 2 * point.units;
  }
  return text;
}

std::optional<std::string> text_of_latin1(std::string_view text) {
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t length = base::utf8_sequence_length(text.substr(at));
    if (length == 0) break;
    at += length;
  }
  if (at == text.size()) return std::nullopt;
  std::string out;
  out.reserve(text.size() + text.size() / 8);
  for (const char c : text) out += base::utf8_of(static_cast<unsigned char>(c));
  return out;
}

bool is_binary(base::Bytes bytes) {
  constexpr std::size_t k_beginning = 4096;
  const base::Bytes first = bytes.first(std::min(bytes.size(), k_beginning));
  return std::any_of(first.begin(), first.end(), [](std::uint8_t byte) {
    return byte < 0x20 && byte != '\t' && byte != '\n' && byte != '\r' && byte != '\f' && byte != 0x1a;
  });
}

}  // namespace penpose::io
