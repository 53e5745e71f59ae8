#include "firmware_io/decode/table/json_tree.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <nlohmann/json.hpp>

#include "core/base/numbers.h"

namespace penpose::decode {
namespace {

constexpr std::size_t k_longest_document = 16U << 20;
constexpr std::size_t k_deepest = 32;

/// Builds the tree from the parser's events, so that no document can make it recurse.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  JsonValue root;
  std::string message;
  std::size_t position = 0;

  bool null() override { return add({.kind = JsonValue::Kind::null}) != nullptr; }
  bool boolean(bool value) override { return add({.kind = JsonValue::Kind::boolean, .boolean = value}) != nullptr; }
  bool number_integer(number_integer_t value) override { return add_number(static_cast<double>(value)); }
  bool number_unsigned(number_unsigned_t value) override { return add_number(static_cast<double>(value)); }
  bool number_float(number_float_t value, const string_t&) override { return add_number(value); }
  bool string(string_t& value) override {
    return add({.kind = JsonValue::Kind::text, .text = std::move(value)}) != nullptr;
  }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(JsonValue::Kind::object); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(JsonValue::Kind::array); }
  bool end_array() override { return close(); }
  bool key(string_t& value) override {
    key_ = std::move(value);
    return true;
  }
  bool parse_error(std::size_t at, const std::string&, const nlohmann::detail::exception&) override {
    position = at > 0 ? at - 1 : 0;
    message = "is no JSON";
    return false;
  }

 private:
  bool add_number(double value) { return add({.kind = JsonValue::Kind::number, .number = value}) != nullptr; }
  JsonValue* add(JsonValue value) {
    if (open_.empty()) {
      root = std::move(value);
      return &root;
    }
    // Only the innermost open container grows, so pointers to the containers around it stay good.
    JsonValue& into = *open_.back();
    if (into.kind == JsonValue::Kind::array) return &into.items.emplace_back(std::move(value));
    return &into.members.emplace_back(std::move(key_), std::move(value)).second;
  }
  bool open(JsonValue::Kind kind) {
    if (open_.size() == k_deepest) {
      message = "is nested more than 32 deep";
      return false;
    }
    open_.push_back(add({.kind = kind}));
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  std::vector<JsonValue*> open_;
  std::string key_;
};

const JsonValue& missing_value() {
  static const JsonValue value;
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

base::Result<JsonValue> parse_json(std::string_view text) {
  if (text.size() > k_longest_document) return base::Error{"is longer than 16 MiB", "", "name a tablet file"};
  TreeBuilder builder;
  try {
    if (nlohmann::json::sax_parse(text.begin(), text.end(), &builder)) return std::move(builder.root);
  } catch (const std::bad_alloc&) {
    throw;  // no fault of what is read
  } catch (const std::exception&) {
    builder.message = "is no JSON";
  }
  return base::Error{builder.message, "byte " + std::to_string(builder.position), "check it with a JSON validator"};
}

bool JsonPlace::present() const {
  return value_->kind != JsonValue::Kind::missing && value_->kind != JsonValue::Kind::null;
}

JsonPlace JsonPlace::at(std::string_view name) const {
  if (present() && value_->kind != JsonValue::Kind::object) fail("is no object", "put { } around its members");
  const auto found = std::find_if(value_->members.begin(), value_->members.end(),
                                  [&](const auto& member) { return member.first == name; });
  return {found == value_->members.end() ? missing_value() : found->second, *error_, pointer_to(pointer_, name)};
}

std::vector<JsonPlace> JsonPlace::items() const {
  if (present() && !is_array()) fail("is no array", "put [ ] around its items");
  std::vector<JsonPlace> places;
  places.reserve(value_->items.size());
  for (std::size_t i = 0; i < value_->items.size(); ++i) {
    places.push_back({value_->items[i], *error_, pointer_ + "/" + std::to_string(i)});
  }
  return places;
}

std::vector<std::pair<std::string, JsonPlace>> JsonPlace::members() const {
  if (present() && value_->kind != JsonValue::Kind::object) fail("is no object", "put { } around its members");
  std::vector<std::pair<std::string, JsonPlace>> places;
  for (const auto& [name, value] : value_->members) {
    places.emplace_back(name, JsonPlace{value, *error_, pointer_to(pointer_, name)});
  }
  return places;
}

std::string JsonPlace::text(std::size_t longest) const {
  if (!is_text()) {
    fail(present() ? "is no text" : "is missing", "write a text in quotes");
    return {};
  }
  if (value_->text.size() > longest) {
    fail("is longer than " + std::to_string(longest) + " bytes", "shorten it");
    return {};
  }
  return value_->text;
}

std::int64_t JsonPlace::integer(std::int64_t least, std::int64_t most) const {
  const double value = number(static_cast<double>(least), static_cast<double>(most));
  if (value != std::floor(value)) fail("is no whole number", "leave the fraction out");
  return static_cast<std::int64_t>(std::floor(value));
}

double JsonPlace::number(double least, double most) const {
  if (value_->kind != JsonValue::Kind::number) {
    fail(present() ? "is no number" : "is missing", "write a number without quotes");
    return least;
  }
  if (!(value_->number >= least && value_->number <= most)) {
    fail("is out of range", "write " + base::format_double(least) + " to " + base::format_double(most));
    return least;
  }
  return value_->number;
}

bool JsonPlace::boolean() const {
  if (value_->kind != JsonValue::Kind::boolean) {
    fail(present() ? "is no true or false" : "is missing", "write true or false");
  }
  return value_->boolean;
}

void JsonPlace::allow_only(std::initializer_list<std::string_view> names) const {
  if (present() && value_->kind != JsonValue::Kind::object) fail("is no object", "put { } around its members");
  for (const auto& [name, value] : value_->members) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    std::string known;
    for (const auto allowed : names) known.append(known.empty() ? "" : ", ").append(allowed);
    JsonPlace{value, *error_, pointer_to(pointer_, name)}.fail("is not known here", "known are " + known);
    return;
  }
}

void JsonPlace::fail(std::string what, std::string remedy) const {
  if (!error_->what.empty()) return;
  *error_ = {std::move(what), pointer_.empty() ? "/" : pointer_, std::move(remedy)};
}

}  // namespace penpose::decode
