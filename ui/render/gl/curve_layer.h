#pragma once

#include <span>

#include "core/base/result.h"
#include "core/geometry/camera.h"
#include "ui/render/cpu/triangles/triangle_raster.h"
#include "ui/render/gl/gl_program.h"
#include "ui/render/gl/screen_fill.h"
#include "ui/render/picture/image.h"
#include "ui/render/scene.h"

namespace penpose::render {

/// Draws curves over the picture where fragments cannot say their depth: the processor draws them, and what it has
/// drawn is laid over. Keeps a picture and a texture of the current context as large as the px that curves reach.
class CurveLayer {
 public:
  static base::Result<CurveLayer> make(const GlDialect& dialect);
  ~CurveLayer();
  CurveLayer(CurveLayer&& other) noexcept;
  CurveLayer& operator=(CurveLayer&&) = delete;

  /// Into the current framebuffer. Later curves lie over earlier ones, highlighted ones over all.
  void draw(std::span<const CurveDrawing> curves, const geometry::Camera& camera, const ScreenFill& screen);

 private:
  explicit CurveLayer(GlProgram program) : program_(std::move(program)) {}
  void send(const PxRect& part);

  GlProgram program_;
  unsigned texture_ = 0;
  int texture_width_ = 0;
  int texture_height_ = 0;
  Image ink_;  ///< of a whole picture: colours times their alpha
  std::vector<std::uint8_t> sent_;
};

}  // namespace penpose::render
