#include "ui/app/sketch_preview.h"

#include <algorithm>

#include "core/articulation/edit.h"

namespace penpose::app {

using articulation::CurveRole;

void SketchPreview::end() { *this = SketchPreview{}; }

void SketchPreview::stroke_ended() {
  model_.reset();
  region_of_.reset();
  rested_.reset();
}

void SketchPreview::show(const document::Document& document) {
  if (!document.pending) {
    // Between two controls the face is as it was posed.
    model_.reset();
    pose_.reset();
    rested_.reset();
  } else if (rested_ != document.model || !pose_ || model_) {
    rested_ = document.model;
    model_.reset();
    pose_ = rig::rest_pose(*document.model->rig);
  }
  if (region_of_ == document.pending && (document.pending || weights_.empty())) return;
  region_of_ = document.pending;
  if (!document.pending || document.pending->sketch.general.empty() ||
      !set_region(document, document.pending->sketch)) {
    if (!weights_.empty()) ++revision_;
    weights_.clear();
    return;
  }
  const auto& sketch = document.pending->sketch;
  const auto weights = sketch.specific.empty() ? base::Result<articulation::Weights>(base::Error{})
                                               : articulation::specific_region(region_, sketch.specific);
  show_weights(document.model->mesh->vertex_count(), weights ? &weights->weights : nullptr);
}

bool SketchPreview::set_region(const document::Document& document, const articulation::Sketch& sketch) {
  if (canvas_of_ != document.model) {
    auto canvas = document::make_canvas(*document.model);
    if (!canvas) return false;
    canvas_ = std::move(*canvas);
    canvas_of_ = document.model;
    region_lasso_.clear();
  }
  if (region_lasso_ == sketch.general && !region_.vertices.empty()) return true;
  const auto camera = geometry::Camera::make(sketch.camera, sketch.viewport);
  if (!camera) return false;
  auto region = articulation::general_region(*canvas_, *camera, sketch.general);
  if (!region) return false;
  region_ = std::move(*region);
  region_lasso_ = sketch.general;
  return true;
}

void SketchPreview::show_weights(std::size_t vertex_count, const std::vector<double>* weights) {
  weights_.assign(vertex_count, -1.0F);
  for (std::size_t i = 0; i < region_.vertices.size(); ++i) {
    weights_[region_.vertices[i]] = weights != nullptr ? static_cast<float>((*weights)[i]) : 0.0F;
  }
  ++revision_;
}

void SketchPreview::follow(const document::Document& document, const drawing::Tool& tool, const document::View& view,
                           const curve::Stroke& stroke) {
  if (!pose_) show(document);
  const CurveRole step = drawing::next_step(document, tool);
  const auto line = curve::positions_of(stroke);
  articulation::Sketch sketch;
  if (document.pending) sketch = document.pending->sketch;
  if (step == CurveRole::general) {
    sketch.general = line;
    sketch.camera = view.camera;
    sketch.viewport = view.viewport;
    if (line.size() > 2 && set_region(document, sketch)) show_weights(document.model->mesh->vertex_count(), nullptr);
  } else if (step == CurveRole::specific) {
    if (line.size() < 3 || !set_region(document, sketch)) return;
    const auto weights = articulation::specific_region(region_, line);
    if (weights) show_weights(document.model->mesh->vertex_count(), &weights->weights);
  } else if (step == CurveRole::target && line.size() > 3) {
    sketch.target = line;
    if (!(view.camera == sketch.camera)) sketch.target_camera = view.camera;
    build(document, std::move(sketch));
  }
}

void SketchPreview::build(const document::Document& document, articulation::Sketch sketch) {
  if (sketch.name.empty()) sketch.name = "deformer being drawn";
  if (canvas_of_ != document.model) return;
  auto deformer = articulation::build_deformer(sketch, *canvas_);
  if (!deformer) return;
  static const articulation::SketchedDeformers none;
  const auto& before = document.model->deformers ? *document.model->deformers : none;
  auto set = articulation::with_added(before, *deformer);
  if (!set) return;
  auto model = document::with_deformers(*document.model, *set);
  if (!model) return;
  rig::Pose pose = rig::rest_pose(*model->rig);
  if (const auto at = rig::find_parameter(model->rig->parameters(), sketch.name)) {
    pose[*at] = amount_ * sketch.maximum;
  }
  model_ = std::make_shared<const document::Model>(std::move(*model));
  pose_ = std::move(pose);
}

}  // namespace penpose::app
