#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace penpose::base {

// Text to number and back without any locale: "1.5" is one and a half on every machine. The whole text must be the
// number.

/// A finite or non-finite decimal number; a leading '+' is taken, and so are Microsoft's 1.#QNAN, 1.#IND and 1.#INF.
/// Nothing when the text is anything else.
[[nodiscard]] std::optional<double> parse_double(std::string_view text);
[[nodiscard]] std::optional<std::int64_t> parse_int(std::string_view text, int base = 10);
[[nodiscard]] std::optional<std::uint64_t> parse_uint(std::string_view text, int base = 10);

/// The shortest decimal text that reads back as the same double.
[[nodiscard]] std::string format_double(double value);
/// The shortest decimal text that reads back as the same float.
[[nodiscard]] std::string format_float(float value);
/// Fixed notation with `decimals` digits after the point, for people.
[[nodiscard]] std::string format_fixed(double value, int decimals);

/// `text` without blanks and tabs at either end.
[[nodiscard]] std::string_view trim(std::string_view text);

}  // namespace penpose::base
