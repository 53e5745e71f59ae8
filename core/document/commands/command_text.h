#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/document/commands/command.h"

namespace penpose::document {

// A command as one line of text: its name, then "member=value" for every member that is not at its default, separated
// by blanks. Numbers are the shortest decimals that read back the same; in texts all but letters, digits and "_-." is
// written "%XX"; lists are separated by ";", the pieces of an item by ",", those of a view by "/":
//
//   set_parameters values=jawOpen,0.5;browInnerUp,1
//   draw_target curve=1 view=0,0.1,0.8/0,0,0/0,1,0/30/1000x1000 line=412,300;415.5,301

[[nodiscard]] std::string to_text(const Command& command);

/// Members that are missing keep their defaults. Errors (place: the member): a command or a member that is not known, a
/// member given twice, a value of another form, a number that is not finite, too many points.
[[nodiscard]] base::Result<Command> parse_command(std::string_view text);

/// A view alone, as commands write it.
[[nodiscard]] std::string to_text(const View& view);
[[nodiscard]] base::Result<View> parse_view(std::string_view text);

}  // namespace penpose::document
