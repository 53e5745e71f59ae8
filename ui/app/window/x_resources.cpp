#include "ui/app/window/x_resources.h"

#include <SDL2/SDL_loadso.h>
#include <memory>

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

std::string x_resources() {
  const std::unique_ptr<void, Unload> library(SDL_LoadObject(k_library));
  if (!library) return {};
  // As X11/Xlib.h declares them; a display is opaque here.
  auto* open = function_of<void*(const char*)>(library.get(), "XOpenDisplay");
  auto* resources = function_of<char*(void*)>(library.get(), "XResourceManagerString");
  auto* close = function_of<int(void*)>(library.get(), "XCloseDisplay");
  if (open == nullptr || resources == nullptr || close == nullptr) return {};
  void* display = open(nullptr);
  if (display == nullptr) return {};
  const char* text = resources(display);
  std::string copy = text != nullptr ? text : "";
  close(display);
  return copy;
}

}  // namespace penpose::app
