#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "ui/app/view/draw_frame.h"
#include "ui/render/renderer.h"

struct SDL_Window;
struct ImDrawData;

namespace penpose::app {

/// Shows frames in a window, by one way to draw. Made on any thread; all calls from the one that draws.
class Presenter {
 public:
  virtual ~Presenter() = default;
  Presenter(const Presenter&) = delete;
  Presenter& operator=(const Presenter&) = delete;

  /// First. Errors: those of the renderer.
  virtual base::Status begin() = 0;
  /// Last; also after a `begin` that failed.
  virtual void end() = 0;
  /// Draws the model, the curves and the panels over them. Errors: those of the renderer.
  virtual base::Status draw(const DrawFrame& frame, ImDrawData& panels) = 0;
  /// Puts what was drawn on the screen; comes back when the next may be drawn.
  virtual void show() = 0;
  /// The letters have changed.
  virtual void send_letters() = 0;
  /// Whether the same picture drawn again would be smoother.
  [[nodiscard]] virtual bool refining() const = 0;
  /// Textures that could not be unpacked, as Look::undrawn; each is told once.
  [[nodiscard]] virtual std::vector<std::string> take_undrawn() = 0;
  /// The size that what is drawn into has by now, where the system can be asked.
  [[nodiscard]] virtual std::optional<geometry::Viewport> drawable() const = 0;

 protected:
  Presenter() = default;
};

/// By OpenGL, in a context of the window that no thread has as its own. Precondition: the way is not the processor.
[[nodiscard]] std::unique_ptr<Presenter> make_gl_presenter(SDL_Window* window, void* context, render::DrawWay way);

}  // namespace penpose::app
