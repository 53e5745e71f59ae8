#include "core/base/text/letters.h"

#include <algorithm>

namespace penpose::base {

std::string lower_case(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = lower(c);
  return out;
}

bool same_but_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return lower(x) == lower(y); });
}

void append_hex(std::string& out, std::uint64_t value, std::size_t digits, HexCase letters) {
  const std::string_view names = letters == HexCase::upper ? "0123456789ABCDEF" : "0123456789abcdef";
  while (digits > 0) out += names[(value >> (4 * --digits)) & 15U];
}

std::string_view without_mark(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  return text;
}

}  // namespace penpose::base
