#include "replay/recording/hex_line.h"

#include <algorithm>

#include "core/base/text/letters.h"

namespace penpose::replay {

std::string_view next_word(std::string_view& rest) {
  constexpr std::string_view k_blanks = " \t";
  rest.remove_prefix(std::min(rest.find_first_not_of(k_blanks), rest.size()));
  const std::string_view word = rest.substr(0, rest.find_first_of(k_blanks));
  rest.remove_prefix(word.size());
  return word;
}

std::optional<std::uint64_t> decimal_number(std::string_view text, std::uint64_t most) {
  if (text.empty()) return std::nullopt;
  std::uint64_t value = 0;
  for (const char c : text) {
    if (c < '0' || c > '9' || value > most / 10) return std::nullopt;
    value = value * 10 + static_cast<std::uint64_t>(c - '0');
  }
  if (value > most) return std::nullopt;
  return value;
}

std::optional<std::uint16_t> usb_id(std::string_view text) {
  if (text.empty() || text.size() > 4) return std::nullopt;
  unsigned value = 0;
  for (const char c : text) {
    const auto digit = base::hex_value(c);
    if (!digit) return std::nullopt;
    value = value * 16 + *digit;
  }
  return static_cast<std::uint16_t>(value);
}

std::optional<UsbIds> usb_ids(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const auto vendor = usb_id(text.substr(0, colon));
  const auto product = usb_id(text.substr(colon + 1));
  if (!vendor || !product) return std::nullopt;
  return UsbIds{*vendor, *product};
}

bool append_hex_words(std::string_view words, std::vector<std::uint8_t>& bytes) {
  for (std::string_view word = next_word(words); !word.empty(); word = next_word(words)) {
    if (word.size() != 2 || bytes.size() >= k_most_report_bytes) return false;
    const auto high = base::hex_value(word[0]);
    const auto low = base::hex_value(word[1]);
    if (!high || !low) return false;
    bytes.push_back(static_cast<std::uint8_t>(*high * 16 + *low));
  }
  return true;
}

}  // namespace penpose::replay
