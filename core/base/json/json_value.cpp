#include "core/base/json/json_value.h"

#include <algorithm>

namespace penpose::json {
namespace {

const Json::object_t& no_members() {
  static const Json::object_t none;
  return none;
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
  place_ = other.place_;
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
    const auto at = made.held_.members->emplace(std::move(*member.at(0).held_.text), std::move(member.at(1))).first;
    at->second.place_ = static_cast<std::uint32_t>(&item - items.begin());
  }
  return made;
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

std::vector<const Json::object_t::value_type*> Json::members_as_made() const {
  std::vector<const object_t::value_type*> members;
  members.reserve(items().size());
  for (const auto& member : items()) members.push_back(&member);
  std::stable_sort(members.begin(), members.end(),
                   [](const auto* a, const auto* b) { return a->second.place_ < b->second.place_; });
  return members;
}

Json& Json::operator[](std::string_view name) {
  if (is_null()) *this = object();
  if (!is_object()) throw type_error();
  const auto found = held_.members->find(name);
  if (found != held_.members->end()) return found->second;
  Json& made = held_.members->emplace(std::string(name), nullptr).first->second;
  made.place_ = static_cast<std::uint32_t>(held_.members->size());
  return made;
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
