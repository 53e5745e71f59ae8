#pragma once

#include <functional>
#include <vector>

namespace CLI {
class App;
}

namespace penpose::cli {

inline constexpr int k_success = 0;
inline constexpr int k_failure = 1;
inline constexpr int k_wrong_usage = 2;

/// Adds a subcommand to the app; when it runs it stores its exit status in the second argument, which outlives the app.
using AddCommand = std::function<void(CLI::App&, int&)>;

/// One function for each subcommand, in the order in which --help lists them. Each lives in `NAME_command.cpp`.
[[nodiscard]] std::vector<AddCommand> all_commands();

}  // namespace penpose::cli
