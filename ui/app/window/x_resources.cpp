#include "ui/app/window/x_resources.h"

#include <SDL2/SDL_loadso.h>
#include <memory>

#include "ui/app/canvas/own_scale.h"

namespace penpose::app {
namespace {

constexpr const char* k_library = "libX11.so.6";

struct Unload {
  void operator()(void* library) const { SDL_UnloadObject(library); }
};

/// A function of the library; null where it has none of that name.
template <typename Function>
Function* function_of(void* library, const char* name) {
  return reinterpret_cast<Function*>(SDL_LoadFunction(library, name));
}

}  // namespace

XDisplaySays ask_x_display() {
  const std::unique_ptr<void, Unload> library(SDL_LoadObject(k_library));
  if (!library) return {};
  // As X11/Xlib.h declares them; a display is opaque here.
  auto* open = function_of<void*(const char*)>(library.get(), "XOpenDisplay");
  auto* resources = function_of<char*(void*)>(library.get(), "XResourceManagerString");
  auto* screen = function_of<int(void*)>(library.get(), "XDefaultScreen");
  auto* width = function_of<int(void*, int)>(library.get(), "XDisplayWidth");
  auto* width_mm = function_of<int(void*, int)>(library.get(), "XDisplayWidthMM");
  auto* close = function_of<int(void*)>(library.get(), "XCloseDisplay");
  if (open == nullptr || resources == nullptr || close == nullptr) return {};
  void* display = open(nullptr);
  if (display == nullptr) return {};
  XDisplaySays says;
  if (const char* text = resources(display)) says.resources = text;
  if (screen != nullptr && width != nullptr && width_mm != nullptr) {
    const int shown = screen(display);
    says.dpi = dpi_of(width(display, shown), width_mm(display, shown));
  }
  close(display);
  return says;
}

}  // namespace penpose::app
