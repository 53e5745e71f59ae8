#pragma once

#include <string_view>
#include <tuple>
#include <type_traits>

// Structs that name their members:
//
//   static auto members(auto& self) { return base::named("center", self.center, "radius", self.radius); }

namespace penpose::base {

/// A member of a struct, by its name in files.
template <typename Value>
struct Named {
  std::string_view name;
  Value& value;
  friend bool operator==(const Named& a, const Named& b) { return a.value == b.value; }
};

constexpr std::tuple<> named() { return {}; }
/// Names and members by turns.
template <typename Value, typename... Rest>
constexpr auto named(std::string_view name, Value& value, Rest&... rest) {
  return std::tuple_cat(std::tuple(Named<Value>{name, value}), named(rest...));
}

/// Calls visit(name, value) for each member, in their order.
template <typename One>
void each_member(One& one, auto&& visit) {
  std::apply([&](const auto&... each) { (visit(each.name, each.value), ...); }, std::remove_const_t<One>::members(one));
}

}  // namespace penpose::base
