#include "ui/render/gl/gl_renderer.h"

#include <epoxy/gl.h>
#include <utility>

#include "ui/render/gl/behind_pass.h"
#include "ui/render/gl/curve_pass.h"
#include "ui/render/gl/framebuffers.h"
#include "ui/render/gl/gl_program.h"
#include "ui/render/gl/mesh_pass.h"
#include "ui/render/gl/offscreen_context.h"
#include "ui/render/gl/shaders.h"
#include "ui/render/smoothing.h"

namespace penpose::render {

struct GlRenderer::State {
  std::unique_ptr<OffscreenContext> context;  // first: it has to outlive what lives in it
  GlProgram background;
  GlProgram occlusion;
  GlProgram occlusion_blur;
  MeshPass mesh;
  CurvePass curves;
  BehindPass behind_pass;
  Behind behind;
  Framebuffers targets;
  unsigned empty_array = 0;
  bool occlude = true;
  GlProgram copy;
  bool smooths = false;
  bool still = false;  ///< the last picture could have been drawn again
  int passes = 0;      ///< pictures that were averaged since the last change
  PictureSource last;

  State(std::unique_ptr<OffscreenContext> owned, MeshPass mesh_pass, CurvePass curve_pass)
      : context(std::move(owned)), mesh(std::move(mesh_pass)), curves(std::move(curve_pass)) {
    glGenVertexArrays(1, &empty_array);
  }
  ~State() { glDeleteVertexArrays(1, &empty_array); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  static base::Result<std::unique_ptr<State>> make(std::unique_ptr<OffscreenContext> owned);

  void fill_screen() const {
    glBindVertexArray(empty_array);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
  }
  void draw_surfaces(const Scene& scene, const View& view, geometry::Viewport viewport);
  void add_pass(const Scene& scene, View view, geometry::Viewport viewport);
  void draw_background(const Background& colors) const;
  void draw_occlusion(const View& view, geometry::Viewport viewport);
};

base::Result<std::unique_ptr<GlRenderer::State>> GlRenderer::State::make(std::unique_ptr<OffscreenContext> owned) {
  if (!context_is_enough()) {
    return base::Error{"the driver offers only " + context_name(), "", "OpenGL 3.1 or OpenGL ES 3.0 is needed"};
  }
  auto mesh = MeshPass::make();
  if (!mesh) return mesh.error();
  auto curves = CurvePass::make();
  if (!curves) return curves.error();
  auto background = GlProgram::make(k_screen_vertex, k_background_fragment, {});
  if (!background) return background.error();
  auto occlusion = GlProgram::make(k_screen_vertex, k_occlusion_fragment, {});
  if (!occlusion) return occlusion.error();
  auto blur = GlProgram::make(k_screen_vertex, k_occlusion_blur_fragment, {});
  if (!blur) return blur.error();
  auto copy = GlProgram::make(k_screen_vertex, k_copy_fragment, {});
  if (!copy) return copy.error();
  auto state = std::make_unique<State>(std::move(owned), std::move(*mesh), std::move(*curves));
  state->background = std::move(*background);
  auto behind = BehindPass::make();
  if (!behind) return behind.error();
  state->behind_pass = std::move(*behind);
  state->copy = std::move(*copy);
  state->occlusion = std::move(*occlusion);
  state->occlusion_blur = std::move(*blur);
  return state;
}

void GlRenderer::State::draw_background(const Background& colors) const {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  background.use();
  background.set("top", encode_srgb(colors.top.r), encode_srgb(colors.top.g), encode_srgb(colors.top.b));
  background.set("bottom", encode_srgb(colors.bottom.r), encode_srgb(colors.bottom.g), encode_srgb(colors.bottom.b));
  fill_screen();
}

void GlRenderer::State::draw_occlusion(const View& view, geometry::Viewport viewport) {
  const auto set_common = [&](const GlProgram& program) {
    program.use();
    program.set("depths", 0);
    program.set("depth_to_z", view.depth_to_z.x, view.depth_to_z.y);
    program.set("size_px", static_cast<float>(viewport.width), static_cast<float>(viewport.height));
    program.set("radius", k_occlusion_radius);
  };
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glActiveTexture(GL_TEXTURE0);
  targets.begin_occlusion();
  glBindTexture(GL_TEXTURE_2D, targets.depth_texture());
  set_common(occlusion);
  occlusion.set("image_plane", view.image_plane.x, view.image_plane.y);
  fill_screen();
  targets.begin_picture_without_depth();
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, targets.occlusion_texture());
  set_common(occlusion_blur);
  occlusion_blur.set("occlusion", 1);
  glEnable(GL_BLEND);
  glBlendFunc(GL_DST_COLOR, GL_ZERO);
  fill_screen();
  glDisable(GL_BLEND);
  glBindTexture(GL_TEXTURE_2D, 0);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, 0);
}

void GlRenderer::State::draw_surfaces(const Scene& scene, const View& view, geometry::Viewport viewport) {
  targets.begin_surfaces();
  glClear(GL_DEPTH_BUFFER_BIT);
  draw_background(scene.background);
  if (behind_pass.begin(behind, viewport)) {
    fill_screen();
    BehindPass::end();
  }
  mesh.draw_opaque(view, scene.wireframe);
  mesh.draw_translucent(view);
}

void GlRenderer::State::add_pass(const Scene& scene, View view, geometry::Viewport viewport) {
  if (passes < k_smoothing_passes) {
    view.to_clip[2][0] += 2 * k_smoothing_places[passes][0] / static_cast<float>(viewport.width);
    view.to_clip[2][1] += 2 * k_smoothing_places[passes][1] / static_cast<float>(viewport.height);
    draw_surfaces(scene, view, viewport);
    ++passes;
    targets.average(1.0F / static_cast<float>(passes), [&] {
      glActiveTexture(GL_TEXTURE0);
      glBindTexture(GL_TEXTURE_2D, targets.picture_texture());
      copy.use();
      copy.set("picture", 0);
      fill_screen();
      glBindTexture(GL_TEXTURE_2D, 0);
    });
    glDisable(GL_BLEND);
  }
  targets.show_average();
}

GlRenderer::GlRenderer(std::unique_ptr<State> state) : state_(std::move(state)) {}

GlRenderer::~GlRenderer() {
  if (state_->context) state_->context->make_current();
}

base::Result<std::unique_ptr<GlRenderer>> GlRenderer::make_offscreen() {
  auto context = OffscreenContext::make();
  if (!context) return context.error();
  auto state = State::make(std::move(*context));
  if (!state) return state.error();
  return std::unique_ptr<GlRenderer>(new GlRenderer(std::move(*state)));
}

base::Result<std::unique_ptr<GlRenderer>> GlRenderer::make_in_current_context() {
  auto state = State::make(nullptr);
  if (!state) return state.error();
  return std::unique_ptr<GlRenderer>(new GlRenderer(std::move(*state)));
}

base::Status GlRenderer::draw_picture(const Scene& scene, const geometry::Camera& camera) {
  State& s = *state_;
  if (s.context) s.context->make_current();
  if (auto sized = s.targets.resize(camera.viewport().width, camera.viewport().height); !sized) return sized.error();
  if (auto sent = s.mesh.upload(scene); !sent) return sent.error();
  const View view = make_view(scene.positions, camera);
  glDisable(GL_SCISSOR_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  if (epoxy_is_desktop_gl()) glEnable(GL_MULTISAMPLE);
  const PictureSource now(scene, camera, s.behind);
  s.mesh.order(scene, view);
  const bool same = now.same_as(s.last);
  s.last = now;
  s.still = now.numbered();
  const bool by_passes = s.smooths && s.targets.samples() == 0 && !s.occlude;
  if (!same) {
    s.passes = 0;
    s.draw_surfaces(scene, view, camera.viewport());
    s.targets.resolve();
  } else if (by_passes) {
    s.add_pass(scene, view, camera.viewport());
  } else {
    if (s.targets.samples() == 0) s.draw_surfaces(scene, view, camera.viewport());
    s.targets.resolve();
  }
  if (s.occlude && !scene.triangles.empty()) s.draw_occlusion(view, camera.viewport());
  s.targets.begin_picture();
  s.curves.draw(scene.curves, camera);
  return base::Done{};
}

base::Result<Image> GlRenderer::render(const Scene& scene, const geometry::Camera& camera) {
  if (auto drawn = draw_picture(scene, camera); !drawn) return drawn.error();
  return state_->targets.read();
}

base::Status GlRenderer::draw(const Scene& scene, const geometry::Camera& camera, unsigned framebuffer, int x, int y) {
  if (auto drawn = draw_picture(scene, camera); !drawn) return drawn.error();
  state_->targets.copy_to(framebuffer, x, y);
  return base::Done{};
}

void GlRenderer::set_behind(Behind behind) { state_->behind = std::move(behind); }
void GlRenderer::set_smoothing(bool on) {
  state_->smooths = on;
  state_->targets.set_most_samples(on ? 1 : k_most_samples);
}
std::vector<std::string> GlRenderer::take_undrawn() { return state_->mesh.take_undrawn(); }
bool GlRenderer::refining() const {
  const State& s = *state_;
  return s.smooths && s.still && s.targets.samples() == 0 && !s.occlude && s.passes < k_smoothing_passes;
}
void GlRenderer::set_occlusion(bool on) { state_->occlude = on; }
std::string GlRenderer::driver() const { return context_name(); }

}  // namespace penpose::render
