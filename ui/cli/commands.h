#pragma once

#include <functional>
#include <vector>

#include "ui/files/process/exit_status.h"

namespace CLI {
class App;
}

namespace penpose::cli {

using files::k_failure;
using files::k_success;
using files::k_wrong_usage;

/// Adds a subcommand to the app; when it runs it stores its exit status in the second argument, which outlives the app.
using AddCommand = std::function<void(CLI::App&, int&)>;

/// One function for each subcommand, in the order in which --help lists them. Each lives in `NAME_command.cpp`.
[[nodiscard]] std::vector<AddCommand> all_commands();

}  // namespace penpose::cli
