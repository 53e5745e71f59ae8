#pragma once

#include <string>

#include "ui/cli/parser/command.h"

namespace penpose::cli {

/// Adds "--live NAME=WHERE" to a command that shows frames, where the program has a live output (ui/live).
void add_live_option(const Command& command, std::string& live);

}  // namespace penpose::cli
