#include "ui/cli/commands.h"

#include "ui/cli/render_command.h"

namespace penpose::cli {

std::vector<AddCommand> all_commands() { return {add_render_command}; }

}  // namespace penpose::cli
