#pragma once

#include "core/base/result.h"

namespace penpose::files {

/// Where a shell has closed standard input, output or error, opens something that reads as empty and takes no output:
/// the next file that is opened would take that place otherwise, and what is printed would end up in it.
void hold_standard_streams();

/// Whether all that was printed on standard output is where it should be. Errors: a full disk, a closed output.
[[nodiscard]] base::Status finish_output();

}  // namespace penpose::files
