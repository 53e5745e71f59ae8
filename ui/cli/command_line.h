#pragma once

namespace penpose::cli {

/// Runs the program as the shell calls it and returns its exit status: 0 done, 1 the work failed, 2 wrong usage.
int run(int argc, const char* const* argv);

}  // namespace penpose::cli
