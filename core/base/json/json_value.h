#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace penpose::json {
/// Throws std::out_of_range: a member is asked for that is not there.
[[noreturn]] void refuse_access();
}  // namespace penpose::json

// What is asked for and not there ends in an error, not in undefined behaviour. Whoever needs nlohmann's header takes
// it from here, so that all of the program has the same.
#define JSON_ASSERT(holds) (static_cast<bool>(holds) ? void() : penpose::json::refuse_access())
#include <nlohmann/json.hpp>

#include "core/base/json/json.h"

namespace penpose::json {

/// A value that knows when its object got it.
template <typename Value>
struct Member : Value {
  Member(Value value) noexcept : Value(std::move(value)) {}
  Member(const Member&) = default;
  Member(Member&&) noexcept = default;
  ~Member() = default;
  Member& operator=(Member other) noexcept {
    Value::operator=(std::move(other));
    return *this;
  }
  std::uint32_t place = 0;  ///< among the members of its object; assigning a value leaves it
};

/// The members of an object by name: found in logarithmic time, since files are hostile, and listed in that order. In
/// which order they were made is known, too.
template <typename Name, typename Value, typename Less, typename Allocator>
class Members : public std::map<Name, Member<Value>, Less> {
  using Map = std::map<Name, Member<Value>, Less>;

 public:
  using Map::Map;
  /// The ways in which nlohmann's value adds a member.
  template <typename Text, typename Given>
  std::pair<typename Map::iterator, bool> emplace(Text&& name, Given&& value) {
    const auto added = Map::emplace(std::forward<Text>(name), std::forward<Given>(value));
    if (added.second) added.first->second.place = static_cast<std::uint32_t>(this->size());
    return added;
  }
  Member<Value>& operator[](const Name& name) { return emplace(name, nullptr).first->second; }
};

/// The entries of a list, whose brackets throw std::out_of_range.
template <typename Value, typename Allocator>
class Entries : public std::vector<Value, Allocator> {
 public:
  using std::vector<Value, Allocator>::vector;
  [[nodiscard]] Value& operator[](std::size_t index) { return this->at(index); }
  [[nodiscard]] const Value& operator[](std::size_t index) const { return this->at(index); }
};

/// The members of an object in the order in which they were made; of anything else none.
[[nodiscard]] std::vector<const Json::object_t::value_type*> members_as_made(const Json& value);

}  // namespace penpose::json

/// Frees without taking memory, so that what is half read or half made is given back also where there is none:
/// nlohmann's own lists all values of a tree first, and ends the program where that fails. It recurses as deep as a
/// value is nested, which parse_json bounds.
template <>
inline void penpose::json::Json::json_value::destroy(value_t kind) {
  if (kind == value_t::object) delete object;
  if (kind == value_t::array) delete array;
  if (kind == value_t::string) delete string;
  if (kind == value_t::binary) delete binary;
}
