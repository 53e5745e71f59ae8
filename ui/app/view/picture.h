#pragma once

#include <memory>

#include "core/base/result.h"
#include "ui/app/view/draw_frame.h"
#include "ui/render/gl/gl_renderer.h"

namespace penpose::app {

/// The viewport's picture, in the OpenGL context that is current.
class Picture {
 public:
  /// Errors: those of the renderer.
  static base::Result<std::unique_ptr<Picture>> make();

  /// Draws the model and the curves into the window's framebuffer.
  base::Status draw(const DrawFrame& frame);
  /// Whether the same picture drawn again would be smoother.
  [[nodiscard]] bool refining() const { return renderer_->refining(); }
  /// Textures that could not be unpacked, as Look::undrawn; each is told once.
  [[nodiscard]] std::vector<std::string> take_undrawn() { return renderer_->take_undrawn(); }

 private:
  explicit Picture(std::unique_ptr<render::GlRenderer> renderer) : renderer_(std::move(renderer)) {}

  std::unique_ptr<render::GlRenderer> renderer_;
};

}  // namespace penpose::app
