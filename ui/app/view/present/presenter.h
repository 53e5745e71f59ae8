#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/interface.h"
#include "core/base/result.h"
#include "ui/app/view/draw_frame.h"
#include "ui/render/renderer.h"

struct SDL_Window;
struct ImDrawData;

namespace penpose::app {

/// Shows frames in a window, by one way to draw. Made on any thread; all calls from the one that draws.
class Presenter : public base::Interface {
 public:
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
};

/// A window with a context of OpenGL, which no thread has as its own once a presenter was made of it.
struct GlWindow {
  SDL_Window* window = nullptr;
  void* context = nullptr;
};
/// Asks `open`, which gives null where it cannot, for windows with the flags given until one has a context in which a
/// way draws. Errors: none has, its driver would not survive it, or the program was built without OpenGL. Precondition:
/// the way is not the processor.
[[nodiscard]] base::Result<GlWindow> open_gl_window(render::DrawWay way,
                                                    const std::function<SDL_Window*(std::uint32_t flags)>& open);
[[nodiscard]] std::unique_ptr<Presenter> make_gl_presenter(const GlWindow& window, render::DrawWay way);

}  // namespace penpose::app
