#pragma once

#include "ui/cli/window_request.h"

namespace penpose::cli {

/// Runs the program as the shell calls it and returns its exit status: 0 done, 1 the work failed, 2 wrong usage.
/// Without a subcommand it opens the window; where `open_window` is empty, a subcommand is needed.
int run(int argc, const char* const* argv, const OpenWindow& open_window = {});

}  // namespace penpose::cli
