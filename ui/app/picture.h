#pragma once

#include <memory>

#include "core/base/result.h"
#include "ui/app/app.h"
#include "ui/render/renderer.h"

namespace penpose::app {

/// The viewport's picture, in the OpenGL context that is current.
class Picture {
 public:
  /// Errors: those of the renderer.
  static base::Result<std::unique_ptr<Picture>> make();

  /// Draws the model and the curves as they stand into the window's framebuffer.
  base::Status draw(App& app);

  /// Whether the same picture drawn again would be smoother.
  [[nodiscard]] bool refining() const { return renderer_->refining(); }

 private:
  explicit Picture(std::unique_ptr<render::Renderer> renderer);
  void update_overlay(App& app);

  std::unique_ptr<render::Renderer> renderer_;
  std::vector<render::Color> overlay_;
  std::uint64_t overlay_number_ = 1;
  std::uint64_t weights_revision_ = 0;
  std::shared_ptr<const document::Model> overlay_model_;
  std::string overlay_deformer_;
};

}  // namespace penpose::app
