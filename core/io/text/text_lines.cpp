#include "core/io/text/text_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/numbers.h"
#include "core/base/text/letters.h"

namespace penpose::io {

std::optional<std::string_view> TextLines::next() {
  if (text_.empty()) return std::nullopt;
  ++number_;
  const std::size_t end = std::min(text_.find_first_of("\r\n"), text_.size());
  const std::string_view line = text_.substr(0, end);
  const bool two = text_.substr(end).starts_with("\r\n");
  text_.remove_prefix(std::min(end + (two ? 2 : 1), text_.size()));
  return line;
}

std::optional<std::string_view> TextLines::next_content() {
  while (const auto line = next()) {
    const std::string_view content = base::trim(line->substr(0, line->find('#')));
    if (!content.empty()) return content;
  }
  return std::nullopt;
}

base::Error TextLines::error(std::string what, std::string remedy) const {
  return {std::move(what), "line " + std::to_string(number_), std::move(remedy)};
}

std::string_view first_text(base::Bytes bytes) {
  std::string_view text = base::without_mark(base::as_text(bytes));
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  return text;
}

std::string_view take_word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(" \t"));
  line.remove_prefix(word.size());
  return word;
}

std::optional<double> parse_coordinate(std::string_view word) {
  const auto value = base::parse_double(word);
  if (!value || !(std::abs(*value) <= static_cast<double>(std::numeric_limits<float>::max()))) return std::nullopt;
  return value;
}

}  // namespace penpose::io
