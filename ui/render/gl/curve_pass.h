#pragma once

#include <span>

#include "core/base/result.h"
#include "core/geometry/camera.h"
#include "ui/render/gl/gl_program.h"
#include "ui/render/scene.h"

namespace penpose::render {

/// Draws curves over the picture. Keeps one vertex buffer of the current context.
class CurvePass {
 public:
  /// Precondition: a modern dialect.
  static base::Result<CurvePass> make(const GlDialect& dialect);
  CurvePass() = default;
  ~CurvePass();
  CurvePass(CurvePass&& other) noexcept;
  CurvePass& operator=(CurvePass&&) = delete;
  CurvePass(const CurvePass&) = delete;
  CurvePass& operator=(const CurvePass&) = delete;

  /// Into the current framebuffer, whose depth is cleared and used up: it sorts the pieces of a curve by their distance
  /// from the curve's middle. Later curves lie over earlier ones, highlighted ones over all.
  void draw(std::span<const CurveDrawing> curves, const geometry::Camera& camera) const;

 private:
  GlProgram program_;
  unsigned vertex_array_ = 0;
  unsigned corners_ = 0;
};

}  // namespace penpose::render
