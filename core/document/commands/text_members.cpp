#include "core/document/commands/text_members.h"

#include <algorithm>
#include <set>

namespace penpose::document {

void append_members(std::string& out, std::span<const ReadMember> members, std::span<const ReadMember> initial) {
  std::string text;
  std::string initial_text;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const ReadMember& member = members[i];
    text.clear();
    member.form->write(text, member.value);
    initial_text.clear();
    member.form->write(initial_text, initial[i].value);
    if (text == initial_text) continue;
    out += ' ';
    out += member.name;
    out += '=';
    out += text;
  }
}

base::Status set_members(std::span<const WrittenMember> members, std::string_view text) {
  std::set<std::string_view> given;
  while (!text.empty()) {
    std::string_view piece = take_piece(text, ' ');
    if (piece.empty()) continue;
    const std::string_view name = take_piece(piece, '=');
    if (!given.insert(name).second) return base::Error{"a member is given twice", std::string(name), ""};
    const auto member = std::find_if(members.begin(), members.end(), [&](const auto& one) { return one.name == name; });
    if (member == members.end())
      return base::Error{"the command has no such member", std::string(name.substr(0, 40)), "leave it out"};
    if (!member->form->read(piece, member->value))
      return base::Error{"the value has another form", std::string(name), "write it as the program does"};
  }
  return base::Done{};
}

}  // namespace penpose::document
