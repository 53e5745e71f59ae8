#include "ui/cli/live_option.h"

#include <CLI/CLI.hpp>

#include "ui/live/live.h"

namespace penpose::cli {

void add_live_option(CLI::App& command, std::string& live) {
  if (live::ways_out().empty()) return;
  std::string help = "Send the pose of every frame:";
  for (const live::WayOut& way : live::ways_out()) help += ' ' + std::string(way.name) + '=' + std::string(way.where);
  command.add_option("--live", live, help);
}

}  // namespace penpose::cli
