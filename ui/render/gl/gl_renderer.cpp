#include "ui/render/gl/gl_renderer.h"

#include <epoxy/gl.h>
#include <optional>
#include <string_view>
#include <utility>

#include "ui/render/gl/behind_pass.h"
#include "ui/render/gl/curve_layer.h"
#include "ui/render/gl/curve_pass.h"
#include "ui/render/gl/framebuffers.h"
#include "ui/render/gl/gl_program.h"
#include "ui/render/gl/ground_pass.h"
#include "ui/render/gl/mesh/mesh_pass.h"
#include "ui/render/gl/offscreen_context.h"
#include "ui/render/gl/screen_fill.h"
#include "ui/render/gl/shaders.h"
#include "ui/render/light/crease_radius.h"
#include "ui/render/smoothing.h"

namespace penpose::render {

struct GlRenderer::State {
  std::unique_ptr<OffscreenContext> context;  // first: it has to outlive what lives in it
  GlDialect dialect;
  ScreenFill screen;
  MeshPass mesh;
  GlProgram background;
  GlProgram copy;
  GlProgram occlusion;
  GlProgram occlusion_blur;
  BehindPass behind_pass;
  GroundPass ground_pass;
  std::optional<CurvePass> curve_pass;    ///< modern
  std::optional<CurveLayer> curve_layer;  ///< not modern
  BehindPass veil_pass;
  Behind behind;
  Behind veil;
  Framebuffers targets;
  bool occlude = true;
  bool smooths = false;
  bool still = false;  ///< the last picture could have been drawn again
  int passes = 0;      ///< pictures that were averaged since the last change
  PictureSource last;

  State(std::unique_ptr<OffscreenContext> owned, const GlDialect& of, MeshPass mesh_pass)
      : context(std::move(owned)), dialect(of), screen(of), mesh(std::move(mesh_pass)), targets(of) {}

  static base::Result<std::unique_ptr<State>> make(std::unique_ptr<OffscreenContext> owned, DrawWay way);

  base::Status add_programs();
  [[nodiscard]] bool occludes() const { return occlude && dialect.modern; }
  void copy_texture(unsigned texture) const;
  void draw_surfaces(const Scene& scene, const View& view, geometry::Viewport viewport);
  void add_pass(const Scene& scene, View view, geometry::Viewport viewport);
  void draw_background(const Background& colors) const;
  void draw_occlusion(const View& view, geometry::Viewport viewport);
  void draw_veil(geometry::Viewport viewport);
  void draw_still(const Scene& scene, const View& view, geometry::Viewport viewport, bool same);
};

base::Result<std::unique_ptr<GlRenderer::State>> GlRenderer::State::make(std::unique_ptr<OffscreenContext> owned,
                                                                         DrawWay way) {
  const auto dialect = dialect_of_context(way);
  if (!dialect) return dialect.error();
  auto mesh = MeshPass::make(*dialect);
  if (!mesh) return mesh.error();
  auto state = std::make_unique<State>(std::move(owned), *dialect, std::move(*mesh));
  if (auto added = state->add_programs(); !added) return added.error();
  return state;
}

base::Status GlRenderer::State::add_programs() {
  struct Row {
    GlProgram* program;
    std::string_view fragment;
    bool modern;
  };
  for (const Row& row :
       {Row{&background, k_background_fragment, false}, Row{&copy, k_copy_fragment, false},
        Row{&occlusion, k_occlusion_fragment, true}, Row{&occlusion_blur, k_occlusion_blur_fragment, true}}) {
    if (row.modern && !dialect.modern) continue;
    auto made = GlProgram::make(dialect, k_screen_vertex, row.fragment, {"corner"});
    if (!made) return made.error();
    *row.program = std::move(*made);
  }
  auto behind_made = BehindPass::make(dialect);
  if (!behind_made) return behind_made.error();
  behind_pass = std::move(*behind_made);
  auto ground_made = GroundPass::make(dialect);
  if (!ground_made) return ground_made.error();
  ground_pass = std::move(*ground_made);
  auto veil_made = BehindPass::make(dialect);
  if (!veil_made) return veil_made.error();
  veil_pass = std::move(*veil_made);
  if (!dialect.modern) {
    auto made = CurveLayer::make(dialect);
    if (!made) return made.error();
    curve_layer.emplace(std::move(*made));
    return base::Done{};
  }
  auto made = CurvePass::make(dialect);
  if (!made) return made.error();
  curve_pass.emplace(std::move(*made));
  return base::Done{};
}

/// A texture as large as the picture over all of it.
void GlRenderer::State::copy_texture(unsigned texture) const {
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture);
  copy.use();
  copy.set("picture", 0);
  screen.draw();
  glBindTexture(GL_TEXTURE_2D, 0);
}

void GlRenderer::State::draw_background(const Background& colors) const {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  background.use();
  background.set("top", encode_srgb(colors.top.r), encode_srgb(colors.top.g), encode_srgb(colors.top.b));
  background.set("bottom", encode_srgb(colors.bottom.r), encode_srgb(colors.bottom.g), encode_srgb(colors.bottom.b));
  background.set("vignette", colors.vignette);
  screen.draw();
}

void GlRenderer::State::draw_occlusion(const View& view, geometry::Viewport viewport) {
  const auto set_common = [&](const GlProgram& program) {
    program.use();
    program.set("depths", 0);
    program.set("depth_to_z", view.depth_to_z.x, view.depth_to_z.y);
    program.set("size_px", static_cast<float>(viewport.width), static_cast<float>(viewport.height));
    program.set("radius", crease_radius(view));
  };
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glActiveTexture(GL_TEXTURE0);
  targets.begin_occlusion();
  glBindTexture(GL_TEXTURE_2D, targets.depth_texture());
  set_common(occlusion);
  occlusion.set("image_plane", view.image_plane.x, view.image_plane.y);
  screen.draw();
  targets.begin_picture_without_depth();
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, targets.occlusion_texture());
  set_common(occlusion_blur);
  occlusion_blur.set("occlusion", 1);
  glEnable(GL_BLEND);
  glBlendFunc(GL_DST_COLOR, GL_ZERO);
  screen.draw();
  glDisable(GL_BLEND);
  glBindTexture(GL_TEXTURE_2D, 0);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, 0);
}

void GlRenderer::State::draw_surfaces(const Scene& scene, const View& view, geometry::Viewport viewport) {
  targets.begin_surfaces();
  glClear(GL_DEPTH_BUFFER_BIT);
  draw_background(scene.background);
  const auto draw_behind = [&] {
    const bool shown = behind_pass.begin(behind, viewport);
    if (!shown) return false;
    screen.draw();
    BehindPass::end();
    return true;
  };
  const bool hides_ground = !behind.front && draw_behind();
  if (!hides_ground && scene.appearance != nullptr && ground_pass.begin(scene.appearance->light, view, viewport)) {
    screen.draw();
    GroundPass::end();
  }
  mesh.draw_opaque(view, scene.wireframe);
  mesh.draw_translucent(view);
  if (behind.front) static_cast<void>(draw_behind());
}

void GlRenderer::State::add_pass(const Scene& scene, View view, geometry::Viewport viewport) {
  if (passes < k_smoothing_passes) {
    view.to_clip[2][0] += 2 * k_smoothing_places[passes][0] / static_cast<float>(viewport.width);
    view.to_clip[2][1] += 2 * k_smoothing_places[passes][1] / static_cast<float>(viewport.height);
    draw_surfaces(scene, view, viewport);
    ++passes;
    const auto fill = [&](unsigned texture) { copy_texture(texture); };
    targets.average(1.0F / static_cast<float>(passes), fill);
    glDisable(GL_BLEND);
  }
  targets.show_average([&](unsigned texture) { copy_texture(texture); });
}

void GlRenderer::State::draw_veil(geometry::Viewport viewport) {
  veil.to = {static_cast<double>(viewport.width), static_cast<double>(viewport.height)};
  if (!veil_pass.begin(veil, viewport)) return;
  // The picture stays opaque.
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  screen.draw();
  BehindPass::end();
}

/// Surfaces that do not change while this picture is drawn.
void GlRenderer::State::draw_still(const Scene& scene, const View& view, geometry::Viewport viewport, bool same) {
  const bool one_sample = !dialect.modern || targets.samples() == 0;
  if (!same) passes = 0;
  if (!dialect.modern && !smooths) {
    // All at once.
    if (passes == k_smoothing_passes) return add_pass(scene, view, viewport);
    while (passes < k_smoothing_passes) add_pass(scene, view, viewport);
  } else if (same && smooths && one_sample && !occludes()) {
    add_pass(scene, view, viewport);
  } else {
    // Samples are still there when nothing has changed.
    if (!same || one_sample) draw_surfaces(scene, view, viewport);
    targets.resolve();
  }
}

GlRenderer::GlRenderer(std::unique_ptr<State> state) : state_(std::move(state)) {}

GlRenderer::~GlRenderer() {
  if (state_->context) state_->context->make_current();
}

base::Result<std::unique_ptr<GlRenderer>> GlRenderer::make_offscreen(DrawWay way) {
  auto context = OffscreenContext::make(way);
  if (!context) return context.error();
  auto state = State::make(std::move(*context), way);
  if (!state) return state.error();
  return std::unique_ptr<GlRenderer>(new GlRenderer(std::move(*state)));
}

base::Result<std::unique_ptr<GlRenderer>> GlRenderer::make_in_current_context(DrawWay way) {
  auto state = State::make(nullptr, way);
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
  if (s.dialect.modern && !s.dialect.embedded) glEnable(GL_MULTISAMPLE);
  const PictureSource now(scene, camera, s.behind);
  s.mesh.order(scene, view);
  const bool same = now.same_as(s.last);
  s.last = now;
  s.still = now.numbered();
  s.draw_still(scene, view, camera.viewport(), same);
  if (s.occludes() && !scene.triangles.empty() && !s.mesh.has_toon()) s.draw_occlusion(view, camera.viewport());
  s.targets.begin_picture();
  s.draw_veil(camera.viewport());
  if (s.curve_pass) s.curve_pass->draw(scene.curves, camera);
  if (s.curve_layer) s.curve_layer->draw(scene.curves, camera, s.screen);
  return base::Done{};
}

base::Result<Image> GlRenderer::render(const Scene& scene, const geometry::Camera& camera) {
  if (auto drawn = draw_picture(scene, camera); !drawn) return drawn.error();
  return state_->targets.read();
}

base::Status GlRenderer::draw(const Scene& scene, const geometry::Camera& camera, unsigned framebuffer, int x, int y) {
  if (auto drawn = draw_picture(scene, camera); !drawn) return drawn.error();
  state_->targets.copy_to(framebuffer, x, y, [&](unsigned texture) { state_->copy_texture(texture); });
  return base::Done{};
}

const GlDialect& GlRenderer::dialect() const { return state_->dialect; }
void GlRenderer::set_behind(Behind behind) { state_->behind = std::move(behind); }
void GlRenderer::set_veil(std::shared_ptr<const Image> veil) { state_->veil.image = std::move(veil); }
void GlRenderer::set_smoothing(bool on) {
  state_->smooths = on;
  state_->targets.set_most_samples(on ? 1 : k_most_samples);
}
std::vector<std::string> GlRenderer::take_undrawn() { return state_->mesh.take_undrawn(); }
bool GlRenderer::refining() const {
  const State& s = *state_;
  return s.smooths && s.still && s.targets.samples() == 0 && !s.occludes() && s.passes < k_smoothing_passes;
}
void GlRenderer::set_occlusion(bool on) { state_->occlude = on; }
std::string GlRenderer::driver() const { return context_name(); }

}  // namespace penpose::render
