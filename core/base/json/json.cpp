#include "core/base/json/json.h"

#include <algorithm>
#include <cmath>

namespace penpose::json {
namespace {

base::Error at_byte(std::string what, std::size_t offset, std::string remedy) {
  return {std::move(what), "byte offset " + std::to_string(offset), std::move(remedy)};
}

}  // namespace

base::Result<Json> parse_json(base::Bytes bytes) {
  try {
    return Json::parse(base::as_text(bytes), k_max_json_depth);
  } catch (const Json::parse_error& error) {
    switch (error.fault) {
      case Json::Fault::depth:
        return at_byte("JSON nested more than " + std::to_string(k_max_json_depth) + " levels deep", error.byte - 1,
                       "the file is damaged or hostile");
      case Json::Fault::number:
        return at_byte("JSON with a number that is too large", error.byte - 1, "the file is damaged; export it again");
      default:
        return at_byte("no valid JSON", error.byte > 0 ? error.byte - 1 : 0, "the file is damaged; export it again");
    }
  }
}

std::string child(const std::string& pointer, std::string_view name) {
  std::string result = pointer + "/";
  for (const char c : name) {
    if (c == '~') {
      result += "~0";
    } else if (c == '/') {
      result += "~1";
    } else {
      result += c;
    }
  }
  return result;
}

std::string child(const std::string& pointer, std::size_t index) { return pointer + "/" + std::to_string(index); }

const Json* find(const Json& object, const char* name) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(name);
  return found == object.end() ? nullptr : &*found;
}

std::optional<std::int64_t> whole_number(const Json& value, std::int64_t minimum, std::int64_t maximum) {
  std::int64_t result = 0;
  if (value.is_number_unsigned()) {
    const auto raw = value.get<std::uint64_t>();
    if (raw > static_cast<std::uint64_t>(std::max<std::int64_t>(maximum, 0))) return std::nullopt;
    result = static_cast<std::int64_t>(raw);
  } else if (value.is_number_integer()) {
    result = value.get<std::int64_t>();
  } else if (value.is_number_float()) {
    const double raw = value.get<double>();
    if (!(std::abs(raw) <= 9007199254740992.0) || raw != std::floor(raw)) return std::nullopt;
    result = static_cast<std::int64_t>(raw);
  } else {
    return std::nullopt;
  }
  if (result < minimum || result > maximum) return std::nullopt;
  return result;
}

std::optional<double> number(const Json& value) {
  if (!value.is_number()) return std::nullopt;
  const double result = value.get<double>();
  if (!std::isfinite(result)) return std::nullopt;
  return result;
}

void list_unknown(const Json& object, const std::string& pointer, std::span<const std::string_view> known,
                  std::vector<std::string>& skipped) {
  for (const auto& [name, value] : object.items()) {
    if (std::find(known.begin(), known.end(), name) == known.end()) skipped.push_back(child(pointer, name));
  }
}

}  // namespace penpose::json
