#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ui/render/gl/gl_dialect.h"
#include "ui/render/renderer.h"

namespace penpose::render {

/// Draws scenes with OpenGL 3.1 or OpenGL ES 3.0, or with what OpenGL ES 2.0 and OpenGL 2.1 share: without darkening of
/// creases then, and instead of several samples a px with the average of several pictures.
class GlRenderer final : public Renderer {
 public:
  /// A renderer without a window, a display or a graphics card. Errors: there is no OpenGL at all.
  /// Precondition of both: the way is not the processor.
  static base::Result<std::unique_ptr<GlRenderer>> make_offscreen(DrawWay way);
  /// A renderer in the context that is current now and stays so. Errors: older than the way needs.
  static base::Result<std::unique_ptr<GlRenderer>> make_in_current_context(DrawWay way);
  ~GlRenderer() override;

  base::Result<Image> render(const Scene& scene, const geometry::Camera& camera) override;
  /// The same into a framebuffer of the current context (0: the window), its lower left corner at x, y px. Leaves the
  /// bound program, arrays, viewport, depth test and blending changed.
  base::Status draw(const Scene& scene, const geometry::Camera& camera, unsigned framebuffer = 0, int x = 0, int y = 0);

  /// What its context is asked for, for whoever draws beside it.
  [[nodiscard]] const GlDialect& dialect() const;
  void set_behind(Behind behind) override;
  void set_veil(std::shared_ptr<const Image> veil) override;
  void set_occlusion(bool on) override;
  void set_smoothing(bool on) override;
  [[nodiscard]] std::vector<std::string> take_undrawn() override;
  [[nodiscard]] bool refining() const override;
  [[nodiscard]] std::string driver() const override;

 private:
  struct State;
  explicit GlRenderer(std::unique_ptr<State> state);
  base::Status draw_picture(const Scene& scene, const geometry::Camera& camera);

  std::unique_ptr<State> state_;
};

}  // namespace penpose::render
