#pragma once

#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/base/members.h"
#include "core/base/result.h"
#include "core/document/commands/text_form.h"

// The text form of a struct with `members` (base/members.h): " member=value" for every member that is not at its
// default.

namespace penpose::document {

/// How values of a type are written and read, without the type: what walks over members is compiled once, not for each
/// struct.
struct ValueForm {
  void (*write)(std::string& out, const void* value);
  bool (*read)(std::string_view text, void* value);  ///< false: the value has another form, and stays
};
template <typename Value>
inline constexpr ValueForm k_value_form{[](std::string& out, const void* value) {
                                          const auto& known = *static_cast<const Value*>(value);
                                          if constexpr (requires { known.has_value(); }) {
                                            if (!known.has_value()) return;
                                          }
                                          TextForm<Value>::write(out, known);
                                        },
                                        [](std::string_view text, void* value) {
                                          auto parsed = TextForm<Value>::read(text);
                                          if (parsed) *static_cast<Value*>(value) = *std::move(parsed);
                                          return parsed.has_value();
                                        }};

/// A member of a struct that outlives it.
template <typename Pointer>
struct AnyMember {
  std::string_view name;
  Pointer value;
  const ValueForm* form;
};
using ReadMember = AnyMember<const void*>;
using WrittenMember = AnyMember<void*>;

[[nodiscard]] std::vector<ReadMember> any_members(const auto& one) {
  std::vector<ReadMember> members;
  base::each_member(one, [&]<typename Value>(std::string_view name, const Value& value) {
    members.push_back({name, &value, &k_value_form<Value>});
  });
  return members;
}
[[nodiscard]] std::vector<WrittenMember> any_members(auto& one) {
  std::vector<WrittenMember> members;
  base::each_member(one, [&]<typename Value>(std::string_view name, Value& value) {
    members.push_back({name, &value, &k_value_form<Value>});
  });
  return members;
}

/// Appends the members whose text differs from that of the initial ones, each with a blank in front. Both are of one
/// struct.
void append_members(std::string& out, std::span<const ReadMember> members, std::span<const ReadMember> initial);
/// Sets members from their text; those that are missing keep their values. Errors (place: the member): a member that is
/// not known or given twice, a value of another form.
[[nodiscard]] base::Status set_members(std::span<const WrittenMember> members, std::string_view text);

/// Appends the members that differ from a default-constructed struct, each with a blank in front.
template <typename One>
void append_members(std::string& out, const One& one) {
  const One initial;
  append_members(out, any_members(one), any_members(initial));
}

/// Members that are missing keep their defaults. Errors: those of set_members.
template <typename One>
base::Result<One> parse_members(std::string_view text) {
  One command;
  if (auto status = set_members(any_members(command), text); !status) return status.error();
  return command;
}

}  // namespace penpose::document
