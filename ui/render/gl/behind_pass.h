#pragma once

#include <memory>

#include "core/base/result.h"
#include "core/geometry/camera.h"
#include "ui/render/gl/gl_program.h"
#include "ui/render/picture/image.h"

namespace penpose::render {

/// A picture behind everything else: its corners in px of the view, y down, and how much of it shows.
struct Behind {
  std::shared_ptr<const Image> image;  ///< null: none
  geometry::PxPoint from;
  geometry::PxPoint to;
  float opacity = 1;
  friend bool operator==(const Behind&, const Behind&) = default;
};

/// Draws it over the background. One OpenGL context only.
class BehindPass {
 public:
  static base::Result<BehindPass> make();
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
