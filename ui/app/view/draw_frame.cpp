#include "ui/app/view/draw_frame.h"

#include <algorithm>

#include "core/articulation/edit.h"
#include "ui/app/view/backdrop.h"
#include "ui/app/widgets/internal/tokens.h"

namespace penpose::app {
namespace {

/// The surface shows through the colours of weights.
constexpr float k_overlay_alpha = 0.62F;
constexpr float k_faint_weight = 0.25F;

}  // namespace

void FrameMaker::update_surface() {
  const PosedSurface& surface = parts_.canvas.surface();
  // Another character has another surface, whose numbers may be the same.
  const std::pair shape(surface.model().mesh.get(), surface.shape_number());
  if (std::exchange(shape_, shape) != shape) {
    ++last_.shape_number;
    last_.appearance = std::make_shared<const render::Appearance>(surface.appearance());
  }
  // Not the document's: a panel may have opened another one since.
  last_.model = surface.shared_model();
  const std::pair pose(last_.model.get(), surface.pose_number());
  if (std::exchange(pose_, pose) == pose) return;
  ++last_.pose_number;
  const auto positions = surface.positions();
  const auto normals = surface.normals();
  last_.positions = std::make_shared<const std::vector<glm::vec3>>(positions.begin(), positions.end());
  last_.normals = std::make_shared<const std::vector<glm::vec3>>(normals.begin(), normals.end());
}

void FrameMaker::update_overlay() {
  const SketchPreview& sketch = parts_.editing.shown().sketch();
  const bool sketching = parts_.editing.editor().tool().kind == drawing::ToolKind::articulate;
  const auto& model = parts_.canvas.surface().shared_model();
  const std::size_t count = model->mesh->vertex_count();
  const auto colored = [](float weight) {
    render::Color color = render::weight_color(weight);
    color.a = k_overlay_alpha;
    return color;
  };
  if (sketching && !sketch.weights().empty()) {
    overlay_deformer_.clear();
    overlay_model_.reset();
    if (sketch.revision() == weights_revision_ && last_.overlay && last_.overlay->size() == count) return;
    weights_revision_ = sketch.revision();
    std::vector<render::Color> overlay(count, render::Color{0, 0, 0, 0});
    for (std::size_t i = 0; i < std::min(count, sketch.weights().size()); ++i) {
      if (sketch.weights()[i] >= 0) overlay[i] = colored(sketch.weights()[i]);
      if (sketch.weights()[i] == -2.0F) overlay[i] = render::from_srgb(0xe8402a, k_overlay_alpha);
    }
    last_.overlay = std::make_shared<const std::vector<render::Color>>(std::move(overlay));
    ++last_.overlay_number;
    return;
  }
  const std::string name = parts_.controls.shown();
  const auto& deformers = model->deformers;
  const auto found = name.empty() || !deformers ? std::nullopt : articulation::find_deformer(*deformers, name);
  if (!found) {
    if (last_.overlay) ++last_.overlay_number;
    last_.overlay.reset();
    overlay_deformer_.clear();
    overlay_model_.reset();
    return;
  }
  if (overlay_model_ == model && overlay_deformer_ == name) return;
  overlay_model_ = model;
  overlay_deformer_ = name;
  std::vector<render::Color> overlay(count, render::Color{0, 0, 0, 0});
  const articulation::Deformer& deformer = *deformers->deformers()[*found];
  for (std::size_t i = 0; i < deformer.vertices().size(); ++i) {
    const auto weight = static_cast<float>(deformer.weights()[i]);
    render::Color& color = overlay[deformer.vertices()[i]];
    color = colored(weight);
    // Little of it is hardly seen, so that the border does not run along the edges of triangles.
    color.a *= std::min(1.0F, weight / k_faint_weight);
  }
  last_.overlay = std::make_shared<const std::vector<render::Color>>(std::move(overlay));
  ++last_.overlay_number;
}

render::Scene scene_of(const DrawFrame& frame) {
  render::Scene scene;
  scene.positions = *frame.positions;
  scene.normals = *frame.normals;
  scene.triangles =
      frame.triangles ? std::span<const mesh::Triangle>(*frame.triangles) : frame.model->mesh->triangles();
  scene.appearance = frame.appearance.get();
  if (frame.overlay) scene.overlay = *frame.overlay;
  scene.curves = frame.curves;
  scene.wireframe = frame.wireframe;
  scene.clay = frame.clay;
  scene.matcap = frame.matcap;
  scene.background = frame.background;
  scene.shape_number = frame.shape_number;
  scene.pose_number = frame.pose_number;
  scene.overlay_number = frame.overlay_number;
  return scene;
}

DrawFrame FrameMaker::make() {
  if (last_.overlay_number == 0) last_.overlay_number = 1;
  update_surface();
  update_overlay();
  const Palette& look = palette_of(parts_.preferences.settings().light);
  last_.background = {render::from_srgb(look.canvas_top), render::from_srgb(look.canvas_foot)};
  last_.wireframe = parts_.look.wireframe;
  last_.clay = parts_.look.clay;
  last_.matcap = parts_.look.matcap;
  last_.view = {parts_.canvas.view().camera, parts_.canvas.window()};
  DrawFrame frame = last_;
  if (parts_.cast.several()) {
    const render::Color ground = render::mix(last_.background.top, last_.background.bottom, 0.5F);
    cast_.put_into(frame, parts_.cast, parts_.canvas.surface(), last_.overlay, ground);
  } else {
    cast_.forget();
  }
  frame.curves = parts_.drawing.curves;
  frame.veil = parts_.drawing.veil;
  frame.behind =
      parts_.look.backdrop ? parts_.look.backdrop->seen(last_.view, parts_.canvas.free_area()) : render::Behind();
  return frame;
}

}  // namespace penpose::app
