#include "ui/app/controls/controls.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/articulation/edit.h"
#include "core/articulation/measure/doubts.h"
#include "core/articulation/mirror.h"

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

/// The value at which a sketched control has its target.
double target_value(const rig::Parameter& parameter) { return std::clamp(1.0, parameter.minimum, parameter.maximum); }

}  // namespace

Controls::Controls(EditingSession& editing, Notices& notices, Canvas& canvas, PanelState& panels)
    : editing_(editing), notices_(notices), canvas_(canvas), panels_(panels), lent_(editing) {}

void Controls::open_document() {
  lent_.forget();
  trial_.clear();
  selected_.clear();
  new_surface_ = {};
  const auto& deformers = editing_.document().model->deformers;
  deformer_count_ = deformers ? deformers->size() : 0;
  seen_deformers_ = deformers;
  const auto& corrections = editing_.document().model->corrections;
  correction_count_ = corrections ? corrections->size() : 0;
}

std::string Controls::shown() const { return panels_.controls_tab ? selected_ : std::string(); }

void Controls::begin() {
  editing_.perform(document::BeginDeformer{free_name(editing_.document(), "control"), new_mode_, new_surface_, 0, 1});
}

void Controls::tell_doubt_of_feature() {
  const auto& pending = editing_.document().pending;
  const drawing::Tool& tool = editing_.editor().tool();
  const std::string& doubt = editing_.shown().sketch().reference_doubt();
  if (!pending || doubted_ == pending || editing_.pen_is_drawing() || doubt.empty() || tool.draw_reference ||
      tool.kind != drawing::ToolKind::articulate ||
      drawing::next_step(editing_.document(), tool) != articulation::CurveRole::target)
    return;
  doubted_ = pending;
  notices_.tell("The green line is the feature that was found, but " + doubt +
                ": \"Draw the feature myself\" takes yours");
}

void Controls::mirror(const std::string& deformer) {
  std::string to = articulation::mirrored_name(deformer);
  // A name without a side.
  if (to.size() > deformer.size() && to.starts_with(deformer)) {
    to = free_name(editing_.document(), deformer + " mirrored", true);
  }
  set_swing(false);
  if (!editing_.perform(document::MirrorDeformer{deformer, to})) return;
  selected_ = to;
  deformer_count_ = editing_.document().model->deformers->size();
  notices_.tell(to + " is ready: " + deformer + " on the other side");
}

void Controls::rename(const std::string& deformer, const std::string& to) {
  if (!editing_.perform(document::RenameDeformer{deformer, to})) return;
  selected_ = to;
  // What was said of it by its old name is no help any more.
  notices_.take_away([&](const Notice& one) { return one.text.find(deformer) != std::string::npos; });
}

void Controls::choose_for_new(articulation::Mode mode, const articulation::Surface& surface) {
  new_mode_ = mode;
  const bool of_region = of_surface(surface, false, [](const auto& one) { return one.k_of_region; });
  new_surface_ = of_region ? articulation::Surface() : surface;
  const auto pending = editing_.document().pending;
  if (pending && !pending->drivers.empty() && !(pending->sketch.mode == mode)) {
    notices_.tell("a correction keeps the motion it began with: cancel it and start again");
    return;
  }
  if (!pending || (pending->sketch.mode == mode && pending->sketch.surface == surface)) return;
  const articulation::Sketch& sketch = pending->sketch;
  const auto draw = [&](articulation::CurveRole role, const std::vector<PxPoint>& line,
                        const geometry::CameraPose& camera) {
    return line.empty() || editing_.perform(document::SketchCurve{role, {camera, sketch.viewport}, line});
  };
  static_cast<void>(
      editing_.perform(document::BeginDeformer{sketch.name, mode, surface, sketch.minimum, sketch.maximum}) &&
      (sketch.reach == articulation::Reach::through || editing_.perform(document::TakeRegion{sketch.reach, {}})) &&
      draw(articulation::CurveRole::general, sketch.general, sketch.camera) &&
      (sketch.piece == 0 || editing_.perform(document::TakeRegion{{}, sketch.piece})) &&
      draw(articulation::CurveRole::specific, sketch.specific, sketch.camera) &&
      draw(articulation::CurveRole::reference, sketch.reference, sketch.reference_camera.value_or(sketch.camera)));
}

void Controls::redraw(const std::string& deformer, articulation::CurveRole role) {
  const auto& deformers = editing_.document().model->deformers;
  const auto number = deformers ? articulation::find_deformer(*deformers, deformer) : std::nullopt;
  if (!number) return;
  const articulation::Sketch& sketch = deformers->deformers()[*number]->sketch();
  if (role == articulation::CurveRole::general || role == articulation::CurveRole::specific) {
    canvas_.set_camera(sketch.camera);
  }
  set_swing(false);
  drawing::Tool tool;
  tool.kind = drawing::ToolKind::redraw;
  tool.deformer = deformer;
  tool.role = role;
  editing_.shown().preview(std::nullopt);
  lent_.lend(tool);
}

void Controls::draw_between(const std::string& deformer, double value) {
  set_swing(false);
  drawing::Tool tool;
  tool.kind = drawing::ToolKind::between;
  tool.deformer = deformer;
  tool.value = value;
  const auto index = rig::find_parameter(editing_.document().model->rig->parameters(), deformer);
  if (index) set_parameter(*index, value);
  lent_.lend(tool);
}

void Controls::correct_pose() {
  set_swing(false);
  editing_.shown().preview(std::nullopt);
  if (editing_.document().pending && !editing_.perform(document::CancelDeformer{})) return;
  drawing::Tool tool;
  tool.kind = drawing::ToolKind::articulate;
  selected_.clear();
  panels_.controls_tab = true;
  if (editing_.perform(document::BeginCorrection{{}, {}, new_mode_})) {
    editing_.set_tool(tool);
  }
}

void Controls::set_swing(bool on) {
  swings_ = on;
  if (on) return;
  editing_.shown().preview(std::nullopt);
  editing_.shown().sketch().set_amount(1);
}

void Controls::swing(std::int64_t now_us) {
  if (!swings_) return;
  constexpr double k_period_s = 2;
  const double turns = static_cast<double>(now_us) * 1e-6 / k_period_s;
  const double amount = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * turns);
  editing_.shown().sketch().set_amount(amount);
  const auto& document = editing_.document();
  const auto index = rig::find_parameter(document.model->rig->parameters(), selected_);
  if (document.pending || editing_.pen_is_drawing()) return;
  // Nothing swings out of sight.
  if (!panels_.controls_tab || !index) return set_swing(false);
  preview_parameter(*index, amount * document.model->rig->parameters()[*index].maximum);
}

void Controls::show_new() {
  const auto& deformers = editing_.document().model->deformers;
  const std::size_t count = deformers ? deformers->size() : 0;
  if (count == deformer_count_ + 1 && !editing_.document().pending) {
    selected_ = deformers->deformers().back()->sketch().name;
    panels_.controls_tab = true;
    notices_.tell(selected_ + " is ready and seen at its target: its slider is in the panel");
    for (const std::string& doubt : articulation::doubts_of(*deformers->deformers().back())) notices_.tell(doubt);
    const auto parameters = editing_.document().model->rig->parameters();
    if (const auto number = rig::find_parameter(parameters, selected_)) {
      preview_parameter(*number, target_value(parameters[*number]));
      trial_ = selected_;
    }
  }
  deformer_count_ = count;
  const auto& corrections = editing_.document().model->corrections;
  const std::size_t corrected = corrections ? corrections->size() : 0;
  if (corrected == correction_count_ + 1 && !editing_.document().pending) {
    const articulation::Correction& one = *corrections->all().back();
    notices_.tell(one.drawn.sketch.name + " is there wherever its controls come together");
    for (const std::string& doubt : articulation::doubts_of(*one.deformer)) notices_.tell(doubt);
  }
  correction_count_ = corrected;
}

const std::string* Controls::trial() const {
  if (trial_.empty() || !editing_.shown().previews() || swings_) return nullptr;
  const auto parameters = editing_.document().model->rig->parameters();
  const auto number = rig::find_parameter(parameters, trial_);
  const rig::Pose& shown = editing_.shown().pose();
  const bool seen = number && *number < shown.size() && shown[*number] == target_value(parameters[*number]) &&
                    editing_.document().pose[*number] == parameters[*number].rest;
  return seen ? &trial_ : nullptr;
}

void Controls::end_trial() {
  if (trial() != nullptr) editing_.shown().preview(std::nullopt);
  trial_.clear();
}

void Controls::take_trial() {
  const auto parameters = editing_.document().model->rig->parameters();
  const auto number = trial() != nullptr ? rig::find_parameter(parameters, trial_) : std::nullopt;
  trial_.clear();
  if (number) set_parameter(*number, target_value(parameters[*number]));
}

void Controls::tell_new_doubts() {
  const auto now = editing_.document().model->deformers;
  const auto before = std::exchange(seen_deformers_, now);
  if (!before || !now || before == now) return;
  for (const auto& deformer : now->deformers()) {
    const auto number = articulation::find_deformer(*before, deformer->sketch().name);
    if (!number || before->deformers()[*number] == deformer) continue;
    const auto known = articulation::doubts_of(*before->deformers()[*number]);
    for (const std::string& doubt : articulation::doubts_of(*deformer)) {
      if (std::find(known.begin(), known.end(), doubt) == known.end()) notices_.tell(doubt);
    }
  }
}

void Controls::preview_parameter(std::size_t parameter, double value) {
  rig::Pose pose = editing_.document().pose;
  if (parameter >= pose.size()) return;
  pose[parameter] = value;
  editing_.shown().preview(std::move(pose));
}

void Controls::set_parameter(std::size_t parameter, double value) {
  editing_.shown().preview(std::nullopt);
  const auto parameters = editing_.document().model->rig->parameters();
  if (parameter >= parameters.size()) return;
  const auto& one = parameters[parameter];
  editing_.perform(document::SetParameters{{{one.name, std::clamp(value, one.minimum, one.maximum)}}});
}

}  // namespace penpose::app
