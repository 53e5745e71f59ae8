#pragma once

// Hidden in core/model_io: third-party JSON types appear in no public header.

#include <cstdint>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/result.h"

namespace penpose::model_io {

/// What makes Json a type of its own, for the destructor below; converts as adl_serializer does.
template <typename T, typename Sfinae = void>
struct JsonSerializer : nlohmann::adl_serializer<T, Sfinae> {};

using Json = nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t, std::uint64_t, double,
                                  std::allocator, JsonSerializer>;

/// Nesting above this depth is refused: no model or case file needs it, and readers may recurse. Nor does anything that
/// is written nest deeper.
inline constexpr std::size_t k_max_json_depth = 64;

namespace json_parts {
template <typename Part>
void free_part(Part* part) noexcept {
  // Null where there was no memory for it.
  if (part == nullptr) return;
  std::destroy_at(part);
  std::allocator<Part>().deallocate(part, 1);
}
}  // namespace json_parts

}  // namespace penpose::model_io

/// How a value is freed. The JSON library's own way takes memory for a list of what is still to be freed, which ends
/// the program where there is none; ours recurses, which k_max_json_depth bounds.
template <>
inline void penpose::model_io::Json::json_value::destroy(nlohmann::detail::value_t type) {
  using nlohmann::detail::value_t;
  using penpose::model_io::json_parts::free_part;
  if (type == value_t::object) {
    free_part(object);
  } else if (type == value_t::array) {
    free_part(array);
  } else if (type == value_t::string) {
    free_part(string);
  } else if (type == value_t::binary) {
    free_part(binary);
  }
}

namespace penpose::model_io {

/// Errors: place "byte offset N" (no JSON, nested too deep, a number that does not fit a double).
[[nodiscard]] base::Result<Json> parse_json(base::Bytes bytes);

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

}  // namespace penpose::model_io
