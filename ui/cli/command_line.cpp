#include "ui/cli/command_line.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "ui/cli/commands.h"

namespace penpose::cli {

int run(int argc, const char* const* argv) {
  CLI::App app{"Poses and rigs 3D characters by drawing.", "penpose"};
  app.require_subcommand(1);
  app.set_version_flag("--version", PENPOSE_VERSION);
  int status = k_success;
  for (const auto& add : all_commands()) add(app, status);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? k_success : k_wrong_usage;
  }
  return status;
}

}  // namespace penpose::cli
