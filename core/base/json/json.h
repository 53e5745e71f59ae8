#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/json/json_value.h"
#include "core/base/result.h"

namespace penpose::json {

/// Nesting above this depth is refused: no model or case file needs it, and readers may recurse.
inline constexpr std::size_t k_max_json_depth = 64;

/// Errors: place "byte offset N" (no JSON, nested too deep, a number that does not fit a double).
[[nodiscard]] base::Result<Json> parse_json(base::Bytes bytes);

/// Appends a text in quotes, as JSON. What is no UTF-8 is replaced; what steers a terminal is escaped.
void append_text(std::string& out, std::string_view text);

/// JSON pointer pieces (RFC 6901): POINTER/name with ~ and / escaped, POINTER/3.
[[nodiscard]] std::string child(const std::string& pointer, std::string_view name);
[[nodiscard]] std::string child(const std::string& pointer, std::size_t index);

/// The member of that name, or null when `object` is no object or has none.
[[nodiscard]] const Json* find(const Json& object, const char* name);

/// Adds the JSON pointers of an object's members that are not among the known ones, by their names: a misspelt
/// "surface" would be a control that cuts into the eye without a word.
void list_unknown(const Json& object, const std::string& pointer, std::span<const std::string_view> known,
                  std::vector<std::string>& skipped);
/// A whole number from minimum to maximum, written with or without a fraction of zero.
[[nodiscard]] std::optional<std::int64_t> whole_number(const Json& value, std::int64_t minimum, std::int64_t maximum);
/// A number; JSON has no NaN and no infinity.
[[nodiscard]] std::optional<double> number(const Json& value);

}  // namespace penpose::json
