#include "core/json/json_value.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace penpose::json {
namespace {

/// Builds the value from the parser's events. What is made is in its place at once, so that nothing is lost where
/// memory runs out between two of them.
class Builder {
 public:
  using number_integer_t = std::int64_t;
  using number_unsigned_t = std::uint64_t;
  using number_float_t = double;
  using string_t = std::string;
  using binary_t = nlohmann::json::binary_t;

  Json root;
  std::size_t byte = 0;
  bool too_large = false;

  bool null() { return add(nullptr); }
  bool boolean(bool value) { return add(value); }
  bool number_integer(std::int64_t value) { return add(value); }
  bool number_unsigned(std::uint64_t value) { return add(value); }
  bool number_float(double value, const std::string&) { return add(value); }
  bool string(std::string& value) { return add(std::move(value)); }
  bool binary(binary_t&) { return false; }
  bool start_object(std::size_t) { return open(Json::object()); }
  bool start_array(std::size_t) { return open(Json::array()); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool key(std::string& name) {
    // Of two members of one name the last counts.
    place_ = &(*open_.back())[name];
    *place_ = nullptr;
    return true;
  }
  bool parse_error(std::size_t at, const std::string&, const nlohmann::detail::exception& error) {
    constexpr int k_number_too_large = 406;
    byte = at;
    too_large = error.id == k_number_too_large;
    return false;
  }

 private:
  bool add(Json value) {
    Json* into = &root;
    if (!open_.empty()) {
      if (open_.back()->is_array()) {
        open_.back()->push_back(nullptr);
        into = &(*open_.back())[open_.back()->size() - 1];
      } else {
        into = place_;
      }
    }
    *into = std::move(value);
    last_ = into;
    return true;
  }
  bool open(Json value) {
    add(std::move(value));
    // Only the innermost container grows, so that pointers to those around it stay good.
    open_.push_back(last_);
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  std::vector<Json*> open_;
  Json* place_ = nullptr;  ///< of the member that was named last
  Json* last_ = nullptr;
};

const Json::object_t& no_members() {
  static const Json::object_t none;
  return none;
}

void write_text(std::string& out, const std::string& text) {
  // Most are names, and need nothing done to them.
  const bool plain =
      std::all_of(text.begin(), text.end(), [](char c) { return c >= 0x20 && c < 0x7f && c != '"' && c != '\\'; });
  if (plain) {
    out.append(1, '"').append(text).append(1, '"');
  } else {
    out += nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  }
}

void write_number(std::string& out, double value) {
  if (!std::isfinite(value)) {
    out += "null";
    return;
  }
  std::array<char, 64> digits{};
  char* const end = nlohmann::detail::to_chars(digits.data(), digits.data() + digits.size(), value);
  out.append(digits.data(), end);
}

}  // namespace

Json::Json(std::string text) {
  held_.text = new std::string(std::move(text));
  type_ = value_t::string;
}

Json::Json(std::initializer_list<Item> items) {
  const auto is_member = [](const Item& item) {
    return item.value.is_array() && item.value.size() == 2 && item.value[0].is_string();
  };
  Json made = items.size() > 0 && std::all_of(items.begin(), items.end(), is_member) ? object(items) : array(items);
  swap(made);
}

Json::Json(const Json& other) {
  if (other.is_string()) {
    held_.text = new std::string(*other.held_.text);
  } else if (other.is_array()) {
    held_.list = new array_t(*other.held_.list);
  } else if (other.is_object()) {
    held_.members = new object_t(*other.held_.members);
  } else {
    held_ = other.held_;
  }
  type_ = other.type_;
}

// As deep as it is nested, and readers bound that.
Json::~Json() {
  if (is_string()) delete held_.text;
  if (is_array()) delete held_.list;
  if (is_object()) delete held_.members;
}

Json Json::array() {
  Json made;
  made.held_.list = new array_t();
  made.type_ = value_t::array;
  return made;
}

Json Json::array(std::initializer_list<Item> items) {
  Json made = array();
  made.held_.list->reserve(items.size());
  for (const Item& item : items) made.held_.list->push_back(std::move(item.value));
  return made;
}

Json Json::object() {
  Json made;
  made.held_.members = new object_t();
  made.type_ = value_t::object;
  return made;
}

Json Json::object(std::initializer_list<Item> items) {
  Json made = object();
  for (const Item& item : items) {
    array_t& member = item.value.list();
    made.held_.members->emplace(std::move(*member.at(0).held_.text), std::move(member.at(1)));
  }
  return made;
}

Json Json::parse(std::string_view text) {
  Builder builder;
  if (!nlohmann::json::sax_parse(text.begin(), text.end(), &builder)) {
    throw parse_error(builder.byte, builder.too_large);
  }
  return std::move(builder.root);
}

Json Json::parse(const char* first, const char* last, std::nullptr_t, bool throws) {
  try {
    return parse(std::string_view(first, static_cast<std::size_t>(last - first)));
  } catch (const parse_error&) {
    if (throws) throw;
    return nullptr;
  }
}

std::size_t Json::size() const noexcept {
  if (is_null()) return 0;
  if (is_array()) return held_.list->size();
  return is_object() ? held_.members->size() : 1;
}

Json::const_iterator Json::begin() const {
  if (is_object()) return const_iterator(held_.members->cbegin());
  return is_array() ? const_iterator(held_.list->data()) : const_iterator(this);
}

Json::const_iterator Json::end() const {
  if (is_object()) return const_iterator(held_.members->cend());
  return is_array() ? const_iterator(held_.list->data() + held_.list->size()) : const_iterator(this + size());
}

Json::const_iterator Json::find(std::string_view name) const {
  return is_object() ? const_iterator(held_.members->find(name)) : end();
}

bool Json::contains(std::string_view name) const { return is_object() && held_.members->contains(name); }

const Json::object_t& Json::items() const noexcept { return is_object() ? *held_.members : no_members(); }

Json& Json::operator[](std::string_view name) {
  if (is_null()) *this = object();
  if (!is_object()) throw type_error();
  const auto found = held_.members->find(name);
  if (found != held_.members->end()) return found->second;
  return held_.members->emplace(std::string(name), nullptr).first->second;
}

const Json& Json::at(std::string_view name) const {
  const auto found = items().find(name);
  if (found == items().end()) throw std::out_of_range("a JSON object has no such member");
  return found->second;
}

Json& Json::at(std::string_view name) {
  static_cast<void>(std::as_const(*this).at(name));
  return held_.members->find(name)->second;
}

void Json::push_back(Json value) {
  if (is_null()) *this = array();
  list().push_back(std::move(value));
}

void Json::erase(std::string_view name) {
  if (!contains(name)) return;
  held_.members->erase(held_.members->find(name));
}

void Json::update(const Json& members) {
  for (const auto& [name, value] : members.items()) (*this)[name] = value;
}

const std::string& Json::text() const {
  if (!is_string()) throw type_error();
  return *held_.text;
}

Json::array_t& Json::list() const {
  if (!is_array()) throw type_error();
  return *held_.list;
}

std::string Json::dump(int indent, char, bool, error_handler_t) const {
  std::string out;
  write(out, indent, 0);
  return out;
}

void Json::write(std::string& out, int indent, std::size_t level) const {
  const auto line = [&](std::size_t deep) {
    if (indent >= 0) out.append(1, '\n').append(deep * static_cast<std::size_t>(indent), ' ');
  };
  // What stands between brackets; `each` writes one entry.
  const auto list_all = [&](char opening, const auto& entries, char closing, const auto& each) {
    out += opening;
    bool first = true;
    for (const auto& entry : entries) {
      if (!first) out += ',';
      first = false;
      line(level + 1);
      each(entry);
    }
    if (!first) line(level);
    out += closing;
  };
  switch (type_) {
    case value_t::boolean:
      out += held_.boolean ? "true" : "false";
      return;
    case value_t::number_integer:
      out += std::to_string(held_.integer);
      return;
    case value_t::number_unsigned:
      out += std::to_string(held_.natural);
      return;
    case value_t::number_float:
      write_number(out, held_.real);
      return;
    case value_t::string:
      write_text(out, *held_.text);
      return;
    case value_t::array:
      list_all('[', *held_.list, ']', [&](const Json& entry) { entry.write(out, indent, level + 1); });
      return;
    case value_t::object:
      list_all('{', *held_.members, '}', [&](const auto& member) {
        write_text(out, member.first);
        out += indent >= 0 ? ": " : ":";
        member.second.write(out, indent, level + 1);
      });
      return;
    default:
      out += "null";
  }
}

bool operator==(const Json& a, const Json& b) {
  using value_t = Json::value_t;
  if (a.is_number() && b.is_number()) {
    if (a.is_number_float() || b.is_number_float()) return a.get<double>() == b.get<double>();
    const bool fits =
        (a.is_number_unsigned() || a.held_.integer >= 0) == (b.is_number_unsigned() || b.held_.integer >= 0);
    return fits && a.get<std::uint64_t>() == b.get<std::uint64_t>();
  }
  if (a.type_ != b.type_) return false;
  switch (a.type_) {
    case value_t::boolean:
      return a.held_.boolean == b.held_.boolean;
    case value_t::string:
      return *a.held_.text == *b.held_.text;
    case value_t::array:
      return *a.held_.list == *b.held_.list;
    case value_t::object:
      return *a.held_.members == *b.held_.members;
    default:
      return true;
  }
}

}  // namespace penpose::json
