#pragma once

#include <string>

#include "ui/cli/parser/command.h"

namespace penpose::cli {

/// `--draw gl|es|cpu`: how pictures are drawn; without it the first way that starts.
void add_draw_option(const Command& command, std::string& way);

}  // namespace penpose::cli
