#pragma once

#include <span>
#include <string>

#include "ui/cli/parser/command_table.h"

namespace penpose::pages {

/// What bash, zsh and fish read to complete the program's commands, options and values.
[[nodiscard]] std::string bash_completion(std::span<const cli::CommandRow> table);
[[nodiscard]] std::string zsh_completion(std::span<const cli::CommandRow> table);
[[nodiscard]] std::string fish_completion(std::span<const cli::CommandRow> table);

}  // namespace penpose::pages
