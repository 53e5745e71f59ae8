#include "firmware_io/decode/table/json_place.h"

#include <algorithm>
#include <cmath>

#include "core/base/numbers.h"
#include "core/base/text/joined.h"

namespace penpose::decode {
namespace {

constexpr std::size_t k_longest_document = 16U << 20;
constexpr std::size_t k_deepest = 32;

const json::Json& missing_value() {
  static const json::Json value;
  return value;
}

/// The pointer of a member of what `pointer` leads to. A table of tablets makes ten thousand of them each time that the
/// program starts.
std::string pointer_to(const std::string& pointer, std::string_view name) {
  std::string out;
  out.reserve(pointer.size() + 1 + name.size());
  out.append(pointer).push_back('/');
  for (const char letter : name) {
    if (letter == '~') {
      out += "~0";
    } else if (letter == '/') {
      out += "~1";
    } else {
      out += static_cast<unsigned char>(letter) < 0x20 ? '?' : letter;
    }
  }
  return out;
}

}  // namespace

base::Result<json::Json> parse_json(std::string_view text) {
  if (text.size() > k_longest_document) return base::Error{"is longer than 16 MiB", "", "name a tablet file"};
  try {
    return json::Json::parse(text, k_deepest);
  } catch (const json::Json::parse_error& error) {
    return base::Error{error.fault == json::Json::Fault::depth ? "is nested more than 32 deep" : "is no JSON",
                       "byte " + std::to_string(error.byte > 0 ? error.byte - 1 : 0), "check it with a JSON validator"};
  }
}

void JsonPlace::expect_object() const {
  if (present() && !value_->is_object()) fail("is no object", "put { } around its members");
}

JsonPlace JsonPlace::at(std::string_view name) const {
  expect_object();
  const auto& members = value_->items();
  const auto found = members.find(name);
  return {found == members.end() ? missing_value() : found->second, *error_, pointer_to(pointer_, name)};
}

std::vector<JsonPlace> JsonPlace::items() const {
  if (present() && !is_array()) fail("is no array", "put [ ] around its items");
  std::vector<JsonPlace> places;
  const std::size_t count = is_array() ? value_->size() : 0;
  places.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    places.push_back({(*value_)[i], *error_, pointer_ + "/" + std::to_string(i)});
  }
  return places;
}

std::vector<std::pair<std::string, JsonPlace>> JsonPlace::members() const {
  expect_object();
  std::vector<std::pair<std::string, JsonPlace>> places;
  for (const auto* member : value_->members_as_made()) {
    places.emplace_back(member->first, JsonPlace{member->second, *error_, pointer_to(pointer_, member->first)});
  }
  return places;
}

std::string JsonPlace::text(std::size_t longest) const {
  if (!is_text()) {
    fail(present() ? "is no text" : "is missing", "write a text in quotes");
    return {};
  }
  const auto& text = value_->get_ref<const std::string&>();
  if (text.size() > longest) {
    fail("is longer than " + std::to_string(longest) + " bytes", "shorten it");
    return {};
  }
  return text;
}

std::int64_t JsonPlace::integer(std::int64_t least, std::int64_t most) const {
  const double value = number(static_cast<double>(least), static_cast<double>(most));
  if (value != std::floor(value)) fail("is no whole number", "leave the fraction out");
  return static_cast<std::int64_t>(std::floor(value));
}

double JsonPlace::number(double least, double most) const {
  if (!value_->is_number()) {
    fail(present() ? "is no number" : "is missing", "write a number without quotes");
    return least;
  }
  const auto value = value_->get<double>();
  if (!(value >= least && value <= most)) {
    fail("is out of range", "write " + base::format_double(least) + " to " + base::format_double(most));
    return least;
  }
  return value;
}

bool JsonPlace::boolean() const {
  if (value_->is_boolean()) return value_->get<bool>();
  fail(present() ? "is no true or false" : "is missing", "write true or false");
  return false;
}

void JsonPlace::allow_only(std::initializer_list<std::string_view> names) const {
  expect_object();
  for (const auto* member : value_->members_as_made()) {
    const auto& [name, value] = *member;
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    JsonPlace{value, *error_, pointer_to(pointer_, name)}.fail("is not known here", "known are " + base::joined(names));
    return;
  }
}

void JsonPlace::fail(std::string what, std::string remedy) const {
  if (!error_->what.empty()) return;
  *error_ = {std::move(what), pointer_.empty() ? "/" : pointer_, std::move(remedy)};
}

}  // namespace penpose::decode
