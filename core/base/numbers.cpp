#include "core/base/numbers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
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

/// How Microsoft's older libraries write what is no number: 1.#QNAN, -1.#IND, 1.#INF, with zeros or an exponent behind;
/// few decimals cut and round even these letters (1.#R, 1.#IO).
std::optional<double> parse_microsoft(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  constexpr std::string_view k_begin = "1.#";
  if (!text.starts_with(k_begin)) return std::nullopt;
  text.remove_prefix(k_begin.size());
  const std::size_t letters = std::min(text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ"), text.size());
  const bool infinite = text.substr(0, letters) == "INF";
  text.remove_prefix(letters);
  text.remove_prefix(std::min(text.find_first_not_of('0'), text.size()));
  const bool exponent = text.starts_with("e+") || text.starts_with("e-") || text.starts_with("E+");
  if (exponent && text.find_first_not_of("0123456789", 2) == std::string_view::npos) text = {};
  if (letters == 0 || !text.empty()) return std::nullopt;
  const double value = infinite ? std::numeric_limits<double>::infinity() : std::numeric_limits<double>::quiet_NaN();
  return negative ? -value : value;
}

}  // namespace

std::optional<double> parse_double(std::string_view text) {
  const auto value = parse_whole<double>(text);
  return value ? value : parse_microsoft(text);
}
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
