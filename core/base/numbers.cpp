#include "core/base/numbers.h"

#include <array>
#include <charconv>
#include <system_error>

namespace penpose::base {
namespace {

template <typename T, typename... Options>
std::optional<T> parse_whole(std::string_view text, Options... options) {
  if (text.starts_with('+')) {
    text.remove_prefix(1);
    if (text.starts_with('-') || text.starts_with('+')) return std::nullopt;
  }
  T value{};
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value, options...);
  if (code != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

template <typename T, typename... Options>
std::string format(T value, Options... options) {
  std::array<char, 512> buffer{};
  const auto [end, code] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, options...);
  return code == std::errc{} ? std::string(buffer.data(), end) : std::string("0");
}

}  // namespace

std::optional<double> parse_double(std::string_view text) { return parse_whole<double>(text); }
std::optional<std::int64_t> parse_int(std::string_view text, int base) { return parse_whole<std::int64_t>(text, base); }
std::optional<std::uint64_t> parse_uint(std::string_view text, int base) {
  return parse_whole<std::uint64_t>(text, base);
}

std::string format_double(double value) { return format(value); }
std::string format_float(float value) { return format(value); }
std::string format_fixed(double value, int decimals) { return format(value, std::chars_format::fixed, decimals); }

std::string_view trim(std::string_view text) {
  constexpr std::string_view k_blanks = " \t\r";
  const auto first = text.find_first_not_of(k_blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(k_blanks) - first + 1);
}

}  // namespace penpose::base
