#pragma once

#include "ui/cli/window_request.h"

namespace penpose::program {

/// What opens the window; empty where the program is built without one (PENPOSE_WINDOW=OFF).
[[nodiscard]] cli::OpenWindow window();

}  // namespace penpose::program
