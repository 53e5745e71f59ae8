#pragma once

#include <cstddef>
#include <string_view>
#include <type_traits>

// Structs that name their members:
//
//   static auto members(auto& self) { return base::named("center", self.center, "radius", self.radius); }

namespace penpose::base {

/// Members of a struct with their names in files: the first, and a list of the others. A list of one's own compiles in
/// a fraction of the time of a std::tuple.
template <typename... Values>
struct NamedMembers {
  static constexpr std::size_t k_count = 0;
  void each(auto&) const {}
  friend bool operator==(const NamedMembers&, const NamedMembers&) { return true; }
};
template <typename Value, typename... Rest>
struct NamedMembers<Value, Rest...> {
  static constexpr std::size_t k_count = 1 + sizeof...(Rest);
  std::string_view name;
  Value& value;
  NamedMembers<Rest...> rest;
  void each(auto& visit) const {
    visit(name, value);
    rest.each(visit);
  }
  friend bool operator==(const NamedMembers& a, const NamedMembers& b) {
    return a.value == b.value && a.rest == b.rest;
  }
};

constexpr NamedMembers<> named() { return {}; }
/// Names and members by turns.
template <typename Value, typename... Rest>
constexpr auto named(std::string_view name, Value& value, Rest&... rest) {
  const auto others = named(rest...);
  return [&]<typename... Others>(const NamedMembers<Others...>& list) {
    return NamedMembers<Value, Others...>{name, value, list};
  }(others);
}

/// Calls visit(name, value) for each member, in their order.
template <typename One>
void each_member(One& one, auto&& visit) {
  std::remove_const_t<One>::members(one).each(visit);
}

}  // namespace penpose::base
