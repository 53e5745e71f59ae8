#pragma once

#include <memory>

#include "core/base/result.h"
#include "ui/render/renderer.h"

namespace penpose::render {

/// Whether the address space has room for a driver of OpenGL. Mesa does not survive one that is too small (ulimit -v),
/// so it is asked for before anything of it is started.
[[nodiscard]] base::Status check_room_for_gl();

/// Whether as many threads can be started as a driver of OpenGL does; Mesa waits for ever for those that cannot.
[[nodiscard]] base::Status check_threads_for_gl();

/// An OpenGL context that belongs to no window: SDL's offscreen driver (EGL; Mesa's software renderer where there is no
/// graphics card). Needs no display. Current on the thread that made it, until it is destroyed.
class OffscreenContext {
 public:
  /// Errors: SDL video is in use with another driver (a window is open), or there is no EGL, or none of
  /// versions_of(way).
  static base::Result<std::unique_ptr<OffscreenContext>> make(DrawWay way);
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

  /// Makes it the thread's current context again.
  void make_current();

 private:
  OffscreenContext() = default;

  void* window_ = nullptr;
  void* context_ = nullptr;
  bool video_ = false;
};

}  // namespace penpose::render
