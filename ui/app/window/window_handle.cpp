#include "ui/app/window/window_handle.h"

#include <SDL2/SDL_syswm.h>
#include <array>
#include <cstdio>

namespace penpose::app {

std::string window_handle(SDL_Window* window) {
#if defined(SDL_VIDEO_DRIVER_X11)
  SDL_SysWMinfo info{};
  SDL_VERSION(&info.version);
  if (window == nullptr || SDL_GetWindowWMInfo(window, &info) != SDL_TRUE || info.subsystem != SDL_SYSWM_X11) return {};
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "x11:%lx", static_cast<unsigned long>(info.info.x11.window));
  return text.data();
#else
  return window == nullptr ? std::string() : std::string();
#endif
}

}  // namespace penpose::app
