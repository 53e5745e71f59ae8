#include "core/document/commands/command_text.h"

#include <algorithm>
#include <array>
#include <variant>
#include <vector>

#include "core/document/commands/command_visit.h"
#include "core/document/commands/text_members.h"

namespace penpose::document {
namespace {

/// Commands with all members at their defaults, in the order of CommandTypes.
struct NewCommand {
  std::string_view name;
  Command (*make)();
  std::vector<WrittenMember> (*members)(Command& made);
};
template <typename Types>
constexpr std::array<NewCommand, 0> k_new_commands{};
template <typename... Each>
constexpr std::array<NewCommand, sizeof...(Each)> k_new_commands<std::variant<Each...>>{
    NewCommand{Each::k_called.name, [] { return Command(Each{}); },
               [](Command& made) { return any_members(*made.get_if<Each>()); }}...};

std::vector<ReadMember> members_of(const Command& command) {
  return visit([](const auto& one) { return any_members(one); }, command);
}

}  // namespace

std::string to_text(const Command& command) {
  std::string out(called(command).name);
  const auto& new_commands = k_new_commands<CommandTypes>;
  const Command initial = new_commands[command.index()].make();
  append_members(out, members_of(command), members_of(initial));
  return out;
}

base::Result<Command> parse_command(std::string_view text) {
  const std::string_view name = take_piece(text, ' ');
  const auto& known = k_new_commands<CommandTypes>;
  const auto found = std::find_if(known.begin(), known.end(), [&](const NewCommand& one) { return one.name == name; });
  if (found == known.end()) {
    return base::Error{"there is no command \"" + std::string(name.substr(0, 40)) + "\"", "",
                       "a newer version of the program may know it"};
  }
  Command command = found->make();
  if (auto status = set_members(found->members(command), text); !status) return status.error();
  return command;
}

std::string to_text(const View& view) {
  std::string out;
  TextForm<View>::write(out, view);
  return out;
}

base::Result<View> parse_view(std::string_view text) {
  const auto view = TextForm<View>::read(text);
  if (!view) return base::Error{"a view was expected", "", "write EYE/LOOK_AT/UP/DEGREES/WIDTHxHEIGHT"};
  return *view;
}

}  // namespace penpose::document
