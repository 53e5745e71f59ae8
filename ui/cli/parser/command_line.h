#pragma once

#include "ui/files/window_request.h"

namespace penpose::cli {

/// Runs the program as the shell calls it and returns its exit status: 0 done, 1 the work failed, 2 wrong usage.
/// Without a subcommand it opens the window; where `open_window` is empty, a subcommand is needed.
int run(int argc, const char* const* argv, const files::OpenWindow& open_window = {});

/// From now on memory that is not there ends the program at once, with one line and the status of a failure, before any
/// library that is half done has to give back what it has not got. Files are placed whole or not at all, and sessions
/// are written as they are drawn, so that nothing is lost.
void end_where_memory_ends();

}  // namespace penpose::cli
