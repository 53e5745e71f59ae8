#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ui/cli/commands.h"

namespace penpose::cli {

/// One thing that can be given to a command: an option, a flag, or a positional.
struct OptionRow {
  std::vector<std::string> names;  ///< "-o", "--output"; of a positional its one name
  std::string value;               ///< what stands for its value; empty for a flag
  std::string range;               ///< which values there are, in words; empty where any is good
  std::string fallback;            ///< the value without it; empty where there is none
  std::string help;
  std::vector<std::string> choices;
  std::vector<std::string> extensions;  ///< of the files that fit: ".glb"; empty: all
  std::vector<std::string> excludes;
  std::vector<std::string> needs;
  Completes completes = Completes::nothing;
  bool positional = false;
  bool required = false;
  bool many = false;
};

struct CommandRow {
  std::string name;  ///< empty: the program itself
  std::string help;
  std::vector<OptionRow> options;
  std::vector<Example> examples;
};

/// The command line as it is parsed, read off the parser itself: the program first, then its subcommands in the order
/// of
/// --help. Options that are hidden there are left out.
[[nodiscard]] std::vector<CommandRow> command_table(bool has_window);

/// Name and version: "penpose 0.2.0".
[[nodiscard]] std::string program_version();

}  // namespace penpose::cli
