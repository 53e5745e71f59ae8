#include "core/base/json/loose_json.h"

#include <algorithm>

#include "core/base/numbers.h"
#include "core/base/text/letters.h"

namespace penpose::json {
namespace {

bool of_word(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '+' || c == '-' || c == '.';
}

/// Whether a word between brackets and commas stands for a number that is none.
bool is_no_number(std::string_view word) {
  std::string_view name = word;
  if (name.starts_with('-')) name.remove_prefix(1);
  for (const char* known : {"nan", "infinity", "inf"}) {
    if (base::same_but_case(name, known)) return true;
  }
  // Anything that is not finite has an exponent or is very long.
  if (word.find_first_of("eE") == std::string_view::npos && word.size() < 300) return false;
  try {
    return Json::parse(word).is_null();
  } catch (const Json::parse_error& error) {
    return error.fault == Json::Fault::number;
  }
}

/// The text with null in the place of such words. `grown`: where in it a word became longer by one byte.
std::string with_nulls(std::string_view text, std::vector<std::size_t>& grown) {
  std::string result;
  result.reserve(text.size() + 16);
  bool quoted = false;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (quoted || !of_word(c)) {
      if (c == '"') quoted = !quoted;
      const std::size_t taken = quoted && c == '\\' ? std::min<std::size_t>(2, text.size() - i) : 1;
      result += text.substr(i, taken);
      i += taken;
      continue;
    }
    std::size_t end = i;
    while (end < text.size() && of_word(text[end])) ++end;
    const std::string_view word = text.substr(i, end - i);
    if (is_no_number(word)) {
      result += "null";
      result.append(word.size() - std::min<std::size_t>(4, word.size()), ' ');
      if (word.size() < 4) grown.push_back(result.size() - 1);
    } else {
      result += word;
    }
    i = end;
  }
  return result;
}

}  // namespace

base::Result<Json> parse_loose_json(base::Bytes bytes) {
  auto strict = parse_json(bytes);
  if (strict) return strict;
  std::vector<std::size_t> grown;
  const std::string text = with_nulls(base::as_text(bytes), grown);
  auto json = parse_json(base::as_bytes(text));
  if (json) return json;
  // The place is that of the file as it is.
  base::Error error = json.error();
  constexpr std::string_view k_offset = "byte offset ";
  const auto at = base::parse_uint(std::string_view(error.place).substr(std::min(k_offset.size(), error.place.size())));
  if (at) {
    const auto longer = std::lower_bound(grown.begin(), grown.end(), *at) - grown.begin();
    error.place = std::string(k_offset) + std::to_string(*at - static_cast<std::uint64_t>(longer));
  }
  return error;
}

}  // namespace penpose::json
