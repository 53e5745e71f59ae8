#include "ui/app/view/present/gl/drawable_size.h"

#include <SDL2/SDL.h>
#include <dlfcn.h>
#include <epoxy/glx.h>
#include <string_view>

namespace penpose::app {

std::optional<geometry::Viewport> drawable_size() {
  const char* driver = SDL_GetCurrentVideoDriver();
  if (driver == nullptr || std::string_view(driver) != "x11") return std::nullopt;
  // Where OpenGL ES is all there is nothing has loaded GLX, and nothing needs to have it.
  void* const loaded = ::dlopen("libGL.so.1", RTLD_LAZY | RTLD_NOLOAD);
  if (loaded == nullptr) return std::nullopt;
  ::dlclose(loaded);
  Display* const display = glXGetCurrentDisplay();
  const GLXDrawable drawable = glXGetCurrentDrawable();
  if (display == nullptr || drawable == 0) return std::nullopt;
  unsigned int width = 0;
  unsigned int height = 0;
  glXQueryDrawable(display, drawable, GLX_WIDTH, &width);
  glXQueryDrawable(display, drawable, GLX_HEIGHT, &height);
  if (width == 0 || height == 0) return std::nullopt;
  return geometry::Viewport{static_cast<int>(width), static_cast<int>(height)};
}

}  // namespace penpose::app
