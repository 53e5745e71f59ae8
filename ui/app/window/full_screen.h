#pragma once

#include <cstdint>
#include <optional>

#include "core/geometry/camera.h"

struct SDL_Window;

namespace penpose::app {

/// A window that fills the screen or does not. A window manager is asked for it; where none answers, on a bare X
/// screen, the window is put there by hand.
class FullScreen {
 public:
  /// `window` must outlive this.
  explicit FullScreen(SDL_Window* window);

  void toggle(std::int64_t now_us);
  /// Looks at what came of it; `real` is the size that the window has. True when it was put right.
  bool settle(std::optional<geometry::Viewport> real, std::int64_t now_us);
  /// It is to be looked at again.
  [[nodiscard]] bool waits() const { return asked_us_.has_value(); }

 private:
  struct Place {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
  };
  [[nodiscard]] Place screen() const;

  SDL_Window* window_;
  bool on_ = false;
  Place before_;  ///< the window's own place
  std::optional<std::int64_t> asked_us_;
};

}  // namespace penpose::app
