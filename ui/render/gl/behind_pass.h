#pragma once

#include <memory>

#include "core/base/result.h"
#include "ui/render/behind.h"
#include "ui/render/gl/gl_program.h"

namespace penpose::render {

/// Draws it over the background. One OpenGL context only.
class BehindPass {
 public:
  static base::Result<BehindPass> make(const GlDialect& dialect);
  BehindPass() = default;
  ~BehindPass();
  BehindPass(BehindPass&& other) noexcept;
  BehindPass& operator=(BehindPass&& other) noexcept;

  /// Binds its program; what fills the screen is the caller's. False: there is nothing to draw. Leaves blending on.
  bool begin(const Behind& behind, geometry::Viewport viewport);
  static void end();

 private:
  GlProgram program_;
  unsigned texture_ = 0;
  std::shared_ptr<const Image> sent_;
};

}  // namespace penpose::render
