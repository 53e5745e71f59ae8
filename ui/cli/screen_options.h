#pragma once

#include "ui/cli/parser/command.h"
#include "ui/files/window_request.h"

namespace penpose::cli {

/// `--screen N`, `--rotate DEGREES`, `--rotate-input built-in|all|none`, `--dpi N`, `--screen-kind usual|slow`: the
/// screen that the window is on.
void add_screen_options(const Command& app, files::WindowRequest& request);

}  // namespace penpose::cli
