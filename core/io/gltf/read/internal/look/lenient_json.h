#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "core/base/json/json.h"
#include "core/base/text/utf8.h"

// What is only shown is read leniently: where something is missing or of another kind there is an answer all the same.
namespace penpose::io {

/// Null: there is none, or `object` is null.
inline const json::Json* member(const json::Json* object, const char* name) {
  return object == nullptr ? nullptr : json::find(*object, name);
}

inline const json::Json* item(const json::Json* list, std::size_t index) {
  return list == nullptr || !list->is_array() || index >= list->size() ? nullptr : &(*list)[index];
}

inline const json::Json* extension(const json::Json* object, const char* name) {
  return member(member(object, "extensions"), name);
}

inline std::optional<std::size_t> index_of(const json::Json* object, const char* name) {
  const json::Json* value = member(object, name);
  const auto whole = value == nullptr ? std::nullopt : json::whole_number(*value, 0, 0x7fffffff);
  return whole ? std::optional(static_cast<std::size_t>(*whole)) : std::nullopt;
}

inline double number_of(const json::Json* object, const char* name, double otherwise) {
  const json::Json* value = member(object, name);
  const auto number = value == nullptr ? std::nullopt : json::number(*value);
  return number ? *number : otherwise;
}

inline std::string text_of(const json::Json* object, const char* name) {
  const json::Json* value = member(object, name);
  return value != nullptr && value->is_string() ? base::valid_utf8(value->get_ref<const std::string&>())
                                                : std::string();
}

template <std::size_t n>
std::array<double, n> numbers_of(const json::Json* object, const char* name, std::array<double, n> otherwise) {
  const json::Json* value = member(object, name);
  if (value == nullptr || !value->is_array()) return otherwise;
  for (std::size_t i = 0; i < n && i < value->size(); ++i) {
    if (const auto number = json::number((*value)[i])) otherwise[i] = *number;
  }
  return otherwise;
}

}  // namespace penpose::io
