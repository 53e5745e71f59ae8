#pragma once

#include <string>

namespace CLI {
class App;
}

namespace penpose::cli {

/// Adds "--live NAME=WHERE" to a command that shows frames, where the program has a live output (ui/live).
void add_live_option(CLI::App& command, std::string& live);

}  // namespace penpose::cli
