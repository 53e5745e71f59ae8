#pragma once

#include "ui/cli/window_request.h"

namespace penpose::cli {

/// Runs the program as the shell calls it and returns its exit status: 0 done, 1 the work failed, 2 wrong usage.
/// Without a subcommand it opens the window; where `open_window` is empty, a subcommand is needed.
int run(int argc, const char* const* argv, const OpenWindow& open_window = {});

/// From now on an exception that nothing can catch, such as memory that is missing while memory is given back, ends the
/// program with one line and the status of a failure. Files are placed whole or not at all, so that none is lost.
void end_quietly_on_terminate();

}  // namespace penpose::cli
