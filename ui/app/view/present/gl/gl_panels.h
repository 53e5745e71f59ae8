#pragma once

#include "core/base/result.h"
#include "ui/render/gl/gl_program.h"
#include "ui/render/gl/vertex_array.h"

struct ImDrawData;

namespace penpose::app {

/// Draws ImGui's panels with OpenGL of either dialect, over what the current framebuffer has. ImGui's own back end
/// loads a libGL by itself, which where there is OpenGL ES alone does not exist. One OpenGL context only.
class GlPanels {
 public:
  static base::Result<GlPanels> make(const render::GlDialect& dialect);
  ~GlPanels();
  GlPanels(GlPanels&& other) noexcept;
  GlPanels& operator=(GlPanels&&) = delete;

  /// Sends the picture of the letters as ImGui has it, which must not change meanwhile.
  void send_letters();
  /// Leaves the bound program, viewport and blending changed.
  void draw(const ImDrawData& panels) const;

 private:
  GlPanels(const render::GlDialect& dialect, render::GlProgram program);

  render::GlProgram program_;
  render::VertexArray array_;
  unsigned corners_ = 0;
  unsigned indices_ = 0;
  unsigned letters_ = 0;
};

}  // namespace penpose::app
