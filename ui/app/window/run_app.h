#pragma once

#include "ui/files/window_request.h"

namespace penpose::app {

/// Opens the window and stays until it is closed. Errors: there is no display, or no OpenGL; a file that cannot be
/// opened.
[[nodiscard]] base::Status run_app(const files::WindowRequest& request);

}  // namespace penpose::app
