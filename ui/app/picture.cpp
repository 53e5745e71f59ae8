#include "ui/app/picture.h"

#include "core/articulation/edit.h"

namespace penpose::app {
namespace {

/// The surface shows through the colours of weights.
constexpr float k_overlay_alpha = 0.62F;

bool draws_in_software(const std::string& driver) {
  return driver.find("llvmpipe") != std::string::npos || driver.find("softpipe") != std::string::npos ||
         driver.find("SWR") != std::string::npos;
}

}  // namespace

Picture::Picture(std::unique_ptr<render::Renderer> renderer) : renderer_(std::move(renderer)) {}

base::Result<std::unique_ptr<Picture>> Picture::make() {
  auto renderer = render::Renderer::make_in_current_context();
  if (!renderer) return renderer.error();
  // Darkening of creases would cost the pen its frames where there is no graphics card.
  const bool software = draws_in_software((*renderer)->driver());
  (*renderer)->set_occlusion(!software);
  // Edges averaged from four samples would take it 30 MB and half of its speed; they are smoothed when nothing moves.
  if (software) {
    (*renderer)->set_most_samples(1);
    (*renderer)->set_smoothing(true);
  }
  return std::unique_ptr<Picture>(new Picture(std::move(*renderer)));
}

void Picture::update_overlay(App& app) {
  const SketchPreview& sketch = app.workspace().sketch();
  const bool sketching = app.workspace().editor().tool().kind == drawing::ToolKind::articulate;
  const auto& model = app.workspace().shown_model();
  if (sketching && !sketch.weights().empty()) {
    overlay_deformer_.clear();
    overlay_model_.reset();
    if (sketch.revision() == weights_revision_ && !overlay_.empty()) return;
    weights_revision_ = sketch.revision();
    overlay_.assign(model->mesh->vertex_count(), render::Color{0, 0, 0, 0});
    for (std::size_t i = 0; i < std::min(overlay_.size(), sketch.weights().size()); ++i) {
      if (sketch.weights()[i] < 0) continue;
      overlay_[i] = render::weight_color(sketch.weights()[i]);
      overlay_[i].a = k_overlay_alpha;
    }
    ++overlay_number_;
    return;
  }
  const std::string& name = app.panels().deformer;
  const auto& deformers = model->deformers;
  const auto found = name.empty() || !deformers || !app.panels().controls_tab
                         ? std::nullopt
                         : articulation::find_deformer(*deformers, name);
  if (!found) {
    if (!overlay_.empty()) ++overlay_number_;
    overlay_.clear();
    overlay_deformer_.clear();
    overlay_model_.reset();
    return;
  }
  if (overlay_model_ == model && overlay_deformer_ == name) return;
  overlay_model_ = model;
  overlay_deformer_ = name;
  overlay_.assign(model->mesh->vertex_count(), render::Color{0, 0, 0, 0});
  const articulation::Deformer& deformer = *deformers->deformers()[*found];
  for (std::size_t i = 0; i < deformer.vertices().size(); ++i) {
    const auto weight = static_cast<float>(deformer.weights()[i]);
    render::Color& color = overlay_[deformer.vertices()[i]];
    color = render::weight_color(weight);
    color.a = k_overlay_alpha;
  }
  ++overlay_number_;
}

base::Status Picture::draw(App& app) {
  const PosedSurface& surface = app.surface();
  update_overlay(app);
  render::Scene scene;
  scene.positions = surface.positions();
  scene.normals = surface.normals();
  scene.triangles = surface.model().mesh->triangles();
  scene.appearance = &surface.appearance();
  scene.overlay = overlay_;
  scene.curves = app.curves();
  scene.wireframe = app.panels().wireframe;
  if (app.settings().light) scene.background = {render::from_srgb(0xe4e7ea), render::from_srgb(0xaab2ba)};
  scene.shape_number = surface.shape_number();
  scene.pose_number = surface.pose_number();
  scene.overlay_number = overlay_number_;
  const document::View view{app.view().camera, app.window()};
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  if (!camera) return camera.error();
  return renderer_->draw(scene, *camera, 0, 0, 0);
}

}  // namespace penpose::app
