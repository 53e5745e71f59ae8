#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/result.h"

namespace penpose::json {

template <typename Name, typename Value, typename Less, typename Allocator>
class Members;
template <typename Value, typename Allocator>
class Entries;

/// nlohmann's value, whose objects and lists are ours: json_value.h, for files that look into one.
using Json = nlohmann::basic_json<Members, Entries>;

/// Nesting above this depth is refused: no model or case file needs it, and readers may recurse.
inline constexpr std::size_t k_max_json_depth = 64;

/// Errors: place "byte offset N" (no JSON, nested too deep, a number that does not fit a double).
[[nodiscard]] base::Result<Json> parse_json(base::Bytes bytes);

/// Why a text is refused, and where.
struct Refused {
  enum class Why : std::uint8_t { text, number, depth } why;
  std::size_t offset;
};
/// Reads a text of at most so many levels of brackets. Of two members of one name the last counts.
[[nodiscard]] std::optional<Refused> read_json(std::string_view text, std::size_t deepest, Json& into);

/// As text, in one line, or `indent` spaces deeper with each level. Members are listed by their names. What is no UTF-8
/// is replaced, what is no number is null. Not nlohmann's: its digits are now and then more than a number takes, and it
/// lets stand what steers a terminal.
[[nodiscard]] std::string dump(const Json& value, int indent = -1);
/// The same with members in the order in which they were made: for people, who read from left to right.
[[nodiscard]] std::string dump_as_made(const Json& value, int indent = -1);

/// Appends a text in quotes, as JSON. What is no UTF-8 is replaced; what steers a terminal is escaped.
void append_text(std::string& out, std::string_view text);

/// JSON pointer pieces (RFC 6901): POINTER/name with ~ and / escaped, POINTER/3.
[[nodiscard]] std::string child(const std::string& pointer, std::string_view name);
[[nodiscard]] std::string child(const std::string& pointer, std::size_t index);

/// The member of that name, or null when `object` is no object or has none.
[[nodiscard]] const Json* find(const Json& object, std::string_view name);

/// Adds the JSON pointers of an object's members that are not among the known ones, by their names: a misspelt
/// "surface" would be a control that cuts into the eye without a word.
void list_unknown(const Json& object, const std::string& pointer, std::span<const std::string_view> known,
                  std::vector<std::string>& skipped);
/// A whole number from minimum to maximum, written with or without a fraction of zero.
[[nodiscard]] std::optional<std::int64_t> whole_number(const Json& value, std::int64_t minimum, std::int64_t maximum);
/// A number; JSON has no NaN and no infinity.
[[nodiscard]] std::optional<double> number(const Json& value);

}  // namespace penpose::json
