#include "ui/cli/commands.h"

#include "ui/cli/articulate_command.h"
#include "ui/cli/pose_command.h"
#include "ui/cli/render_command.h"

namespace penpose::cli {

std::vector<AddCommand> all_commands() {
  return {
      add_articulate_command,
      add_pose_command,
      add_render_command,
  };
}

}  // namespace penpose::cli
