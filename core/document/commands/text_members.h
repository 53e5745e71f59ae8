#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/members.h"
#include "core/base/result.h"
#include "core/document/commands/text_form.h"

// The text form of a struct with `members` (base/members.h): " member=value" for every member that is not at its
// default.

namespace penpose::document {

/// Appends the members that differ from a default-constructed struct, each with a blank in front.
template <typename One>
void append_members(std::string& out, const One& one) {
  const auto text_of = [](const auto& value) {
    using Value = std::decay_t<decltype(value)>;
    std::string text;
    if constexpr (requires { value.has_value(); }) {
      if (!value.has_value()) return text;
    }
    TextForm<Value>::write(text, value);
    return text;
  };
  // Both are walked side by side: the same members in the same order.
  const One initial;
  std::vector<std::string> initial_texts;
  base::each_member(initial, [&](std::string_view, const auto& value) { initial_texts.push_back(text_of(value)); });
  std::size_t member = 0;
  base::each_member(one, [&](std::string_view name, const auto& value) {
    const std::string text = text_of(value);
    if (text == initial_texts[member++]) return;
    out += ' ';
    out += name;
    out += '=';
    out += text;
  });
}

/// Sets the member of that name from its text.
template <typename One>
std::optional<base::Error> set_member(One& command, std::string_view name, std::string_view text) {
  bool known = false;
  bool read = false;
  base::each_member(command, [&](std::string_view member, auto& value) {
    if (member != name) return;
    known = true;
    if (auto parsed = TextForm<std::decay_t<decltype(value)>>::read(text)) {
      value = *std::move(parsed);
      read = true;
    }
  });
  if (!known) return base::Error{"the command has no such member", std::string(name.substr(0, 40)), "leave it out"};
  if (!read) return base::Error{"the value has another form", std::string(name), "write it as the program does"};
  return std::nullopt;
}

/// Members that are missing keep their defaults. Errors (place: the member): a member that is not known or given twice,
/// a value of another form.
template <typename One>
base::Result<One> parse_members(std::string_view text) {
  One command;
  std::set<std::string_view> given;
  while (!text.empty()) {
    std::string_view piece = take_piece(text, ' ');
    if (piece.empty()) continue;
    const std::string_view member = take_piece(piece, '=');
    if (!given.insert(member).second) return base::Error{"a member is given twice", std::string(member), ""};
    if (auto error = set_member(command, member, piece)) return *error;
  }
  return command;
}

}  // namespace penpose::document
