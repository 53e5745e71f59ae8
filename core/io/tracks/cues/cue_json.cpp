#include <algorithm>

#include "core/base/numbers.h"
#include "core/io/tracks/cues/internal/cue_reader.h"

namespace penpose::io {

bool begins_json(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && (text[first] == '{' || text[first] == '[');
}

bool mentions(std::string_view text, std::string_view word) {
  constexpr std::size_t k_beginning = 1 << 16;
  return text.substr(0, k_beginning).find(word) != std::string_view::npos;
}

std::optional<double> json_time(const json::Json* value) {
  if (value == nullptr) return std::nullopt;
  if (value->is_string()) return base::parse_double(base::trim(value->get_ref<const std::string&>()));
  return json::number(*value);
}

const json::Json* json_member(const json::Json& object, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    const json::Json* found = json::find(object, name);
    if (found != nullptr && !found->is_null()) return found;
  }
  return nullptr;
}

std::optional<std::string_view> json_text(const json::Json& object, std::initializer_list<const char*> names) {
  const json::Json* found = json_member(object, names);
  if (found == nullptr || !found->is_string()) return std::nullopt;
  return std::string_view(found->get_ref<const std::string&>());
}

}  // namespace penpose::io
