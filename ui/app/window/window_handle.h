#pragma once

#include <string>

struct SDL_Window;

namespace penpose::app {

/// What other programs know a window by, "x11:1a2b"; empty where there is nothing of the kind.
[[nodiscard]] std::string window_handle(SDL_Window* window);

}  // namespace penpose::app
