#include "core/document/commands/command_text.h"

#include "core/document/commands/command_visit.h"
#include "core/document/commands/text_members.h"

namespace penpose::document {
namespace {

template <std::size_t I = 0>
base::Result<Command> parse_named(std::string_view name, std::string_view members) {
  if constexpr (I == std::variant_size_v<CommandTypes>) {
    return base::Error{"there is no command \"" + std::string(name.substr(0, 40)) + "\"", "",
                       "a newer version of the program may know it"};
  } else {
    using One = std::variant_alternative_t<I, CommandTypes>;
    if (One::k_called.name == name) {
      auto command = parse_members<One>(members);
      if (!command) return command.error();
      return Command(std::move(command).value());
    }
    return parse_named<I + 1>(name, members);
  }
}

}  // namespace

std::string to_text(const Command& command) {
  std::string out(called(command).name);
  visit([&](const auto& one) { append_members(out, one); }, command);
  return out;
}

base::Result<Command> parse_command(std::string_view text) {
  const std::string_view name = take_piece(text, ' ');
  return parse_named(name, text);
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
