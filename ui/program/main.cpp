#include <csignal>

#include "ui/cli/commands.h"
#include "ui/cli/parser/command_line.h"
#include "ui/files/process/rights.h"
#include "ui/files/process/standard_streams.h"
#include "ui/program/window.h"

int main(int argc, char** argv) {
  // A file that may not grow is an error like a full disk, and no reason to die.
  std::signal(SIGXFSZ, SIG_IGN);
  penpose::files::hold_standard_streams();
  penpose::cli::end_where_memory_ends();
  // What reads files that somebody else made keeps no right that it does not need.
  const penpose::cli::Subcommand* command = argc > 1 ? penpose::cli::subcommand_named(argv[1]) : nullptr;
  if (command != nullptr) penpose::files::keep_only(command->rights);
  return penpose::cli::run(argc, argv, penpose::program::window());
}
