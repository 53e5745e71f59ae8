#pragma once

#include "ui/files/window_request.h"

namespace penpose::program {

/// What opens the window; empty where the program is built without one (PENPOSE_WINDOW=OFF).
[[nodiscard]] files::OpenWindow window();

}  // namespace penpose::program
