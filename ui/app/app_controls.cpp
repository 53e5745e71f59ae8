#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/articulation/edit.h"
#include "core/articulation/mirror.h"
#include "ui/app/app.h"

// What is done with sketched controls.

namespace penpose::app {
namespace {

/// "control 1", or with the first number that is free; a name that is free already stays as it is where `bare`.
std::string free_name(const document::Document& document, const std::string& name, bool bare = false) {
  const auto parameters = document.model->rig->parameters();
  if (bare && !rig::find_parameter(parameters, name)) return name;
  for (std::size_t n = bare ? 2 : 1;; ++n) {
    std::string numbered = name + " " + std::to_string(n);
    if (!rig::find_parameter(parameters, numbered)) return numbered;
  }
}

}  // namespace

void App::begin_control() {
  workspace_.perform(document::BeginDeformer{free_name(workspace_.document(), "control"), panels_.new_mode,
                                             panels_.new_surface, 0, 1});
}

void App::doubt_feature() {
  const auto& pending = workspace_.document().pending;
  const drawing::Tool& tool = workspace_.editor().tool();
  const std::string& doubt = workspace_.sketch().reference_doubt();
  if (!pending || doubted_ == pending || pen_is_drawing() || doubt.empty() || tool.draw_reference ||
      tool.kind != drawing::ToolKind::articulate ||
      drawing::next_step(workspace_.document(), tool) != articulation::CurveRole::target)
    return;
  doubted_ = pending;
  tell("The green line is the feature that was found, but " + doubt + ": \"Draw the feature myself\" takes yours");
}

void App::mirror_control(const std::string& deformer) {
  std::string to = articulation::mirrored_name(deformer);
  // A name without a side.
  if (to.size() > deformer.size() && to.starts_with(deformer)) {
    to = free_name(workspace_.document(), deformer + " mirrored", true);
  }
  set_swing(false);
  if (!workspace_.perform(document::MirrorDeformer{deformer, to})) return;
  panels_.deformer = to;
  deformer_count_ = workspace_.document().model->deformers->size();
  tell(to + " is ready: " + deformer + " on the other side");
}

void App::rename_control(const std::string& deformer, const std::string& to) {
  if (!workspace_.perform(document::RenameDeformer{deformer, to})) return;
  panels_.deformer = to;
  // What was said of it by its old name is no help any more.
  std::erase_if(notices_, [&](const Notice& one) { return one.text.find(deformer) != std::string::npos; });
}

void App::choose_for_new_control(articulation::Mode mode, const articulation::Surface& surface) {
  panels_.new_mode = mode;
  // A ball was fitted to one region and is none for the next.
  panels_.new_surface = std::holds_alternative<articulation::Sphere>(surface) ? articulation::Surface() : surface;
  const auto pending = workspace_.document().pending;
  if (pending && !pending->drivers.empty() && !(pending->sketch.mode == mode)) {
    tell("how it moves is chosen before a correction is begun: give it up and begin it anew");
    return;
  }
  if (!pending || (pending->sketch.mode == mode && pending->sketch.surface == surface)) return;
  const articulation::Sketch& sketch = pending->sketch;
  const auto draw = [&](articulation::CurveRole role, const std::vector<PxPoint>& line,
                        const geometry::CameraPose& camera) {
    return line.empty() || workspace_.perform(document::SketchCurve{role, {camera, sketch.viewport}, line});
  };
  static_cast<void>(
      workspace_.perform(document::BeginDeformer{sketch.name, mode, surface, sketch.minimum, sketch.maximum}) &&
      (sketch.reach == articulation::Reach::through || workspace_.perform(document::TakeRegion{sketch.reach, {}})) &&
      draw(articulation::CurveRole::general, sketch.general, sketch.camera) &&
      (sketch.piece == 0 || workspace_.perform(document::TakeRegion{{}, sketch.piece})) &&
      draw(articulation::CurveRole::specific, sketch.specific, sketch.camera) &&
      draw(articulation::CurveRole::reference, sketch.reference, sketch.reference_camera.value_or(sketch.camera)));
}

void App::redraw_control(const std::string& deformer, articulation::CurveRole role) {
  const auto& deformers = workspace_.document().model->deformers;
  const auto number = deformers ? articulation::find_deformer(*deformers, deformer) : std::nullopt;
  if (!number) return;
  const articulation::Sketch& sketch = deformers->deformers()[*number]->sketch();
  if (role == articulation::CurveRole::general || role == articulation::CurveRole::specific) {
    view_.camera = sketch.camera;
    framed_ = false;
  }
  set_swing(false);
  drawing::Tool tool;
  tool.kind = drawing::ToolKind::redraw;
  tool.deformer = deformer;
  tool.role = role;
  workspace_.preview(std::nullopt);
  workspace_.set_tool(tool);
}

void App::draw_between(const std::string& deformer, double value) {
  set_swing(false);
  drawing::Tool tool;
  tool.kind = drawing::ToolKind::between;
  tool.deformer = deformer;
  tool.value = value;
  const auto index = rig::find_parameter(workspace_.document().model->rig->parameters(), deformer);
  if (index) set_parameter(*index, value);
  workspace_.set_tool(tool);
}

void App::correct_pose() {
  set_swing(false);
  workspace_.preview(std::nullopt);
  if (workspace_.document().pending && !workspace_.perform(document::CancelDeformer{})) return;
  drawing::Tool tool;
  tool.kind = drawing::ToolKind::articulate;
  panels_.deformer.clear();
  panels_.controls_tab = true;
  if (workspace_.perform(document::BeginCorrection{{}, {}, panels_.new_mode})) {
    workspace_.set_tool(tool);
  }
}

void App::set_swing(bool on) {
  panels_.swing = on;
  if (on) return;
  workspace_.preview(std::nullopt);
  workspace_.sketch().set_amount(1);
}

void App::swing() {
  constexpr double k_period_s = 2;
  const double turns = static_cast<double>(last_frame_us_) * 1e-6 / k_period_s;
  const double amount = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * turns);
  workspace_.sketch().set_amount(amount);
  const auto& document = workspace_.document();
  const auto index = rig::find_parameter(document.model->rig->parameters(), panels_.deformer);
  if (document.pending || pen_is_drawing()) return;
  // Nothing swings out of sight.
  if (!panels_.controls_tab || !index) return set_swing(false);
  preview_parameter(*index, amount * document.model->rig->parameters()[*index].maximum);
}

}  // namespace penpose::app
