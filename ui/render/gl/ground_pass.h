#pragma once

#include <memory>

#include "core/base/result.h"
#include "core/geometry/camera.h"
#include "ui/render/gl/gl_program.h"
#include "ui/render/scene.h"
#include "ui/render/view.h"

namespace penpose::render {

/// Draws the shade on the ground (BakedLight) over the background, before the model. Whoever is below the ground does
/// not see it; from above it hides nothing of what stands on it. One OpenGL context only.
class GroundPass {
 public:
  static base::Result<GroundPass> make(const GlDialect& dialect);
  GroundPass() = default;
  ~GroundPass();
  GroundPass(GroundPass&& other) noexcept;
  GroundPass& operator=(GroundPass&& other) noexcept;

  /// Binds its program; what fills the screen is the caller's. False: there is nothing to draw. Leaves blending on,
  /// and the part of the picture that shows it cut out.
  bool begin(const std::shared_ptr<const BakedLight>& light, const View& view, geometry::Viewport viewport);
  static void end();

 private:
  GlProgram program_;
  unsigned texture_ = 0;
  std::shared_ptr<const BakedLight> sent_;
};

}  // namespace penpose::render
