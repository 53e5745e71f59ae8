#include "ui/cli/live_option.h"

#include "ui/live/live.h"

namespace penpose::cli {

void add_live_option(const Command& command, std::string& live) {
  if (live::live_outputs().empty()) return;
  std::string help = "Send the pose of every frame:";
  for (const live::LiveOutput& output : live::live_outputs())
    help += ' ' + std::string(output.name) + '=' + std::string(output.where);
  command.add_option("--live", live, help);
}

}  // namespace penpose::cli
