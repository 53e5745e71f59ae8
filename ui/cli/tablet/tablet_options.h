#pragma once

#include "ui/cli/parser/command.h"
#include "ui/cli/subcommand.h"
#include "ui/files/own_tablets.h"

namespace penpose::cli {

/// Adds --tablets FILE and --tablet NAME.
void add_tablet_options(const Command& command, files::OwnTablets& own);

}  // namespace penpose::cli
