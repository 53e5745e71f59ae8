#include "ui/app/view/present/gl/drawable_size.h"

#include <SDL2/SDL.h>
#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/glx.h>
#include <string_view>

namespace penpose::app {
namespace {

/// Whether something has loaded a library. Where OpenGL ES is all there is nobody has GLX, and asking it would end the
/// program.
bool loaded(const char* library) {
  void* const found = ::dlopen(library, RTLD_LAZY | RTLD_NOLOAD);
  if (found != nullptr) ::dlclose(found);
  return found != nullptr;
}

std::optional<geometry::Viewport> glx_size() {
  Display* const display = glXGetCurrentDisplay();
  const GLXDrawable drawable = glXGetCurrentDrawable();
  if (display == nullptr || drawable == 0) return std::nullopt;
  unsigned int width = 0;
  unsigned int height = 0;
  glXQueryDrawable(display, drawable, GLX_WIDTH, &width);
  glXQueryDrawable(display, drawable, GLX_HEIGHT, &height);
  return geometry::Viewport{static_cast<int>(width), static_cast<int>(height)};
}

std::optional<geometry::Viewport> egl_size() {
  const EGLDisplay display = eglGetCurrentDisplay();
  const EGLSurface surface = eglGetCurrentSurface(EGL_DRAW);
  if (display == EGL_NO_DISPLAY || surface == EGL_NO_SURFACE) return std::nullopt;
  EGLint width = 0;
  EGLint height = 0;
  eglQuerySurface(display, surface, EGL_WIDTH, &width);
  eglQuerySurface(display, surface, EGL_HEIGHT, &height);
  return geometry::Viewport{width, height};
}

}  // namespace

std::optional<geometry::Viewport> drawable_size() {
  const char* driver = SDL_GetCurrentVideoDriver();
  if (driver == nullptr || std::string_view(driver) != "x11") return std::nullopt;
  std::optional<geometry::Viewport> size;
  if (loaded("libGL.so.1")) size = glx_size();
  if (!size && loaded("libEGL.so.1")) size = egl_size();
  if (size && (size->width == 0 || size->height == 0)) size.reset();
  return size;
}

}  // namespace penpose::app
