#include "ui/app/session/sketch_preview.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/articulation/edit.h"
#include "core/articulation/motion/reference_curve.h"
#include "core/articulation/region/border.h"
#include "core/articulation/region/kept_surface.h"
#include "core/document/commands/apply.h"
#include "core/geometry/lasso.h"

namespace penpose::app {

using articulation::CurveRole;
namespace {

std::optional<std::size_t> correction_of(const document::Document& document, const std::string& name) {
  const auto sketches = document::correction_sketches(*document.model);
  for (std::size_t i = 0; i < sketches.size(); ++i) {
    if (sketches[i].sketch.name == name) return i;
  }
  return std::nullopt;
}

}  // namespace

void SketchPreview::end() { *this = SketchPreview{}; }

void SketchPreview::stroke_ended() {
  refused_core_ = std::exchange(core_, {});
  model_.reset();
  drawn_.reset();
  region_of_.reset();
  rested_.reset();
}

void SketchPreview::show(const document::Document& document, const drawing::Tool& tool) {
  const bool at_rest = tool.kind == drawing::ToolKind::redraw && !correction_of(document, tool.deformer);
  if (!document.pending && !at_rest) {
    // Between two controls the face is as it was posed.
    model_.reset();
    pose_.reset();
    rested_.reset();
  } else if (tool.kind == drawing::ToolKind::articulate && document.pending && !document.pending->drivers.empty()) {
    // A correction is drawn on the pose that it corrects.
    rested_.reset();
    model_.reset();
    pose_ = document.pose;
  } else if (rested_ != document.model || !pose_ || model_) {
    rested_ = document.model;
    model_.reset();
    pose_ = rig::rest_pose(*document.model->rig);
  }
  if (region_of_ == document.pending && (document.pending || weights_.empty())) return;
  region_of_ = document.pending;
  reference_.clear();
  if (!document.pending || !document.pending->sketch.specific.empty()) refused_core_.clear();
  outline_.clear();
  if (!document.pending || document.pending->sketch.general.empty() ||
      !set_region(document, document.pending->sketch)) {
    if (!weights_.empty()) ++revision_;
    weights_.clear();
    return;
  }
  const auto& sketch = document.pending->sketch;
  const auto weights = sketch.specific.empty() ? base::Result<articulation::Weights>(base::Error{})
                                               : articulation::specific_region(region_, sketch.specific);
  const auto& core = sketch.specific.empty() ? refused_core_ : sketch.specific;
  show_weights(document.model->mesh->vertex_count(), weights ? &weights->weights : nullptr, &core);
  if (weights) find_reference(sketch, weights->specific);
}

bool SketchPreview::set_canvas(const document::Document& document) {
  std::vector<articulation::Driver> drivers;
  if (document.pending) drivers = document.pending->drivers;
  if (canvas_of_ == document.model && canvas_pose_ == drivers) return true;
  auto canvas =
      drivers.empty() ? document::make_canvas(*document.model) : document::make_posed_canvas(*document.model, drivers);
  if (!canvas) return false;
  canvas_ = std::move(*canvas);
  canvas_of_ = document.model;
  canvas_pose_ = std::move(drivers);
  region_lasso_.clear();
  return true;
}

bool SketchPreview::set_region(const document::Document& document, const articulation::Sketch& sketch) {
  if (!set_canvas(document)) return false;
  const articulation::Taken taken{sketch.reach, sketch.piece};
  const bool same = region_lasso_ == sketch.general && region_surface_ == sketch.surface && region_taken_ == taken;
  if (same && !region_.vertices.empty()) return true;
  const auto camera = geometry::Camera::make(sketch.camera, sketch.viewport);
  const auto surface = articulation::KeptSurface::make(sketch.surface, *canvas_);
  if (!camera || !surface) return false;
  auto region =
      articulation::general_region(*canvas_, *camera, sketch.general, *surface, articulation::Borders::measured, taken);
  if (!region) return false;
  region_taken_ = taken;
  region_camera_ = *camera;
  region_ = std::move(*region);
  region_lasso_ = sketch.general;
  region_surface_ = sketch.surface;
  return true;
}

void SketchPreview::show_weights(std::size_t vertex_count, const std::vector<double>* weights,
                                 const std::vector<geometry::PxPoint>* core) {
  weights_.assign(vertex_count, -1.0F);
  for (std::size_t i = 0; i < region_.vertices.size(); ++i) {
    weights_[region_.vertices[i]] = weights != nullptr ? static_cast<float>((*weights)[i]) : 0.0F;
  }
  outline_ = canvas_ ? articulation::border_of(*canvas_, region_) : decltype(outline_)();
  const auto lasso =
      core != nullptr && core->size() > 2 ? geometry::Lasso::make(*core) : base::Result<geometry::Lasso>(base::Error{});
  if (lasso && region_camera_ && canvas_) {
    // Of what is hidden behind the face nobody thinks.
    const auto general = geometry::Lasso::make(region_lasso_);
    for (std::uint32_t v = 0; v < std::min(vertex_count, canvas_->positions().size()); ++v) {
      if (weights_[v] != -1.0F) continue;
      const auto px = region_camera_->project(canvas_->positions()[v]);
      if (px && lasso->contains(*px) && !(general && general->contains(*px))) weights_[v] = -2.0F;
    }
  }
  ++revision_;
}

void SketchPreview::find_reference(const articulation::Sketch& sketch, const std::vector<std::uint32_t>& specific) {
  constexpr std::size_t k_points = articulation::k_curve_points;
  base::Result<std::vector<geometry::ModelPoint>> found = base::Error{};
  reference_doubt_.clear();
  if (sketch.reference.empty()) {
    found = articulation::infer_reference(*canvas_, region_, specific, k_points);
    if (found) reference_doubt_ = articulation::doubt_of_inferred(*canvas_, region_, specific, *found);
  } else if (const auto camera =
                 geometry::Camera::make(sketch.reference_camera.value_or(sketch.camera), sketch.viewport)) {
    found = articulation::drawn_reference(*canvas_, *camera, sketch.reference, k_points);
  }
  if (found) reference_ = std::move(*found);
}

std::vector<geometry::ModelPoint> SketchPreview::region_points() const {
  std::vector<geometry::ModelPoint> points;
  if (weights_.empty() || !canvas_) return points;
  for (const std::uint32_t vertex : region_.vertices) {
    if (vertex < canvas_->positions().size()) points.push_back(canvas_->positions()[vertex]);
  }
  return points;
}

void SketchPreview::set_amount(double amount) {
  amount_ = amount;
  if (!model_ || !pose_ || !drawn_) return;
  (*pose_)[*drawn_] = amount_ * model_->rig->parameters()[*drawn_].maximum;
}

void SketchPreview::follow(const document::Document& document, const drawing::Tool& tool, const document::View& view,
                           const curve::Stroke& stroke) {
  if (!pose_) show(document, tool);
  const auto line = curve::positions_of(stroke);
  if (tool.kind == drawing::ToolKind::redraw || tool.kind == drawing::ToolKind::between) {
    if (line.size() > 3) follow_redraw(document, tool, view, line);
    return;
  }
  const CurveRole step = drawing::next_step(document, tool);
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
    core_ = weights ? std::vector<geometry::PxPoint>() : line;
    show_weights(document.model->mesh->vertex_count(), weights ? &weights->weights : nullptr, &line);
    if (!weights) return;
    sketch.reference.clear();
    find_reference(sketch, weights->specific);
  } else if (step == CurveRole::target && line.size() > 3) {
    sketch.target = document::rescaled(line, view.viewport, sketch.viewport);
    if (!(view.camera == sketch.camera)) sketch.target_camera = view.camera;
    if (document.pending && !document.pending->drivers.empty()) return build_correction(document, std::move(sketch));
    build(document, std::move(sketch), std::nullopt);
  }
}

void SketchPreview::pull(const document::Document& document, const document::PullBetween& pull) {
  document::ApplyWorkspace work;
  const auto pulled = document::apply(document, pull, work);
  if (!pulled) return;
  model_ = pulled->model;
  pose_ = pulled->pose;
  drawn_.reset();
  if (const auto number = rig::find_parameter(model_->rig->parameters(), pull.deformer)) (*pose_)[*number] = pull.value;
}

void SketchPreview::follow_redraw(const document::Document& document, const drawing::Tool& tool,
                                  const document::View& view, const std::vector<geometry::PxPoint>& line) {
  if (const auto correction = correction_of(document, tool.deformer)) {
    auto sketches = document::correction_sketches(*document.model);
    articulation::Sketch& sketch = sketches[*correction].sketch;
    auto drawn =
        articulation::redrawn(sketch, tool.role, document::rescaled(line, view.viewport, sketch.viewport), view.camera);
    if (!drawn) return;
    sketch = std::move(drawn).value();
    auto model = document::with_corrections(*document.model, sketches);
    if (!model) return;
    drawn_.reset();
    model_ = std::make_shared<const document::Model>(std::move(*model));
    pose_ = document.pose;
    return;
  }
  if (!document.model->deformers || !set_canvas(document)) return;
  const auto number = articulation::find_deformer(*document.model->deformers, tool.deformer);
  if (!number) return;
  const articulation::Sketch& before = document.model->deformers->deformers()[*number]->sketch();
  if (tool.kind == drawing::ToolKind::between) {
    articulation::Sketch other = before;
    std::erase_if(other.betweens, [&](const auto& one) { return std::abs(one.value - tool.value) < 1e-3; });
    articulation::Between one{tool.value, document::rescaled(line, view.viewport, before.viewport), std::nullopt};
    if (!(view.camera == before.camera)) one.camera = view.camera;
    const auto after = std::find_if(other.betweens.begin(), other.betweens.end(),
                                    [&](const auto& each) { return each.value > tool.value; });
    other.betweens.insert(after, std::move(one));
    return build(document, std::move(other), number, tool.value);
  }
  auto sketch =
      articulation::redrawn(before, tool.role, document::rescaled(line, view.viewport, before.viewport), view.camera);
  if (sketch) build(document, std::move(*sketch), number);
}

void SketchPreview::build(const document::Document& document, articulation::Sketch sketch,
                          std::optional<std::size_t> in_place_of, std::optional<double> at) {
  if (sketch.name.empty()) sketch.name = "deformer being drawn";
  if (!set_canvas(document)) return;
  static const articulation::SketchedDeformers none;
  const auto& before = document.model->deformers ? *document.model->deformers : none;
  base::Result<articulation::SketchedDeformers::Shared> set = base::Error{};
  if (in_place_of) {
    set = articulation::with_sketch(before, *in_place_of, sketch, *canvas_);
  } else if (auto deformer = articulation::build_deformer(sketch, *canvas_)) {
    set = articulation::with_added(before, *deformer);
  }
  if (!set) return;
  auto model = document::with_deformers(*document.model, *set);
  if (!model) return;
  rig::Pose pose = rig::rest_pose(*model->rig);
  drawn_ = rig::find_parameter(model->rig->parameters(), sketch.name);
  if (drawn_) pose[*drawn_] = at ? *at : amount_ * sketch.maximum;
  if (at) drawn_.reset();
  model_ = std::make_shared<const document::Model>(std::move(*model));
  pose_ = std::move(pose);
}

void SketchPreview::build_correction(const document::Document& document, articulation::Sketch sketch) {
  auto sketches = document::correction_sketches(*document.model);
  sketches.push_back({std::move(sketch), document.pending->drivers});
  auto model = document::with_corrections(*document.model, sketches);
  if (!model) return;
  drawn_.reset();
  model_ = std::make_shared<const document::Model>(std::move(*model));
  pose_ = document.pose;
}

}  // namespace penpose::app
