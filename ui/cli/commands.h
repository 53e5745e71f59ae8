#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ui/files/process/exit_status.h"
#include "ui/files/process/rights.h"

namespace CLI {
class App;
}

namespace penpose::cli {

using files::k_failure;
using files::k_success;
using files::k_wrong_usage;

/// A call as one would type it, for the end of --help and of a man page. Tests run every one of them.
struct Example {
  std::string_view call;
  std::string_view does;
};

/// What a shell offers where a value is typed.
enum class Completes : std::uint8_t { nothing, choices, files, folders };

/// What the parser does not know of a value: which files fit, or that it names none.
struct ValueRow {
  std::string_view name;  ///< of the option or positional
  Completes completes = Completes::files;
  std::vector<std::string> extensions = {};  ///< of the files that fit; empty: all
};

/// A subcommand as `NAME_command.cpp` says it at its end.
struct Subcommand {
  std::string_view name;
  files::Rights rights;  ///< what it keeps of the program's rights (docs/security.md)
  /// Adds it to the app; when it runs it stores its exit status in `status`, which outlives the app.
  std::function<void(CLI::App& app, int& status)> add;
  std::array<Example, 2> examples;
  std::vector<ValueRow> values = {};  ///< of options that are this command's own, before those of all (command_table)
};

/// All subcommands, in the order in which --help lists them.
[[nodiscard]] std::span<const Subcommand> subcommands();

/// Null where there is none of that name.
[[nodiscard]] const Subcommand* subcommand_named(std::string_view name);

/// The examples of a subcommand, or of the program itself for an empty name; none for a name that is unknown.
[[nodiscard]] std::span<const Example> examples_of(std::string_view command);

}  // namespace penpose::cli
