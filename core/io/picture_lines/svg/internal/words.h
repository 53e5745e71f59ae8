#pragma once

#include <algorithm>
#include <string_view>

namespace penpose::io {

// Blanks of XML and CSS, where ends of lines are blanks, too.
inline constexpr std::string_view k_svg_blanks = " \t\r\n\f";

/// The text without blanks at either end.
[[nodiscard]] inline std::string_view svg_trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(k_svg_blanks), text.size()));
  return text.substr(0, text.find_last_not_of(k_svg_blanks) + 1);
}

/// Takes the first word off a text; empty at its end.
[[nodiscard]] inline std::string_view take_svg_word(std::string_view& text) {
  text = svg_trimmed(text);
  const std::string_view word = text.substr(0, text.find_first_of(k_svg_blanks));
  text.remove_prefix(word.size());
  return word;
}

}  // namespace penpose::io
