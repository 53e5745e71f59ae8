#include "ui/cli/commands.h"

namespace penpose::cli {

std::vector<AddCommand> all_commands() { return {}; }

}  // namespace penpose::cli
