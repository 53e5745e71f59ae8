#include "ui/app/tour/tour_guide.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/app/files/files.h"
#include "ui/app/playback/frames.h"
#include "ui/app/tour/tour_line.h"

namespace penpose::app {
namespace {

using document::Command;
using geometry::ModelPoint;

// How far lines may stray in the mean, px of the picture in which the tour was drawn.
constexpr double k_feature_px = 20, k_target_px = 20, k_lasso_px = 34;
constexpr double k_near_s = 0.25;
/// A slider is pulled where it should be within this share of its range.
constexpr double k_pulled = 0.2;

/// What a command draws, and in which view; null: it draws nothing.
struct Drawn {
  const document::View* view = nullptr;
  const std::vector<PxPoint>* line = nullptr;
  bool lasso = false;
};

Drawn drawn_by(const Command& command) {
  if (const auto* one = command.get_if<document::DrawReference>()) return {&one->view, &one->line};
  if (const auto* one = command.get_if<document::DrawTarget>()) return {&one->view, &one->line};
  if (const auto* one = command.get_if<document::SketchCurve>()) {
    const bool lasso = one->role == articulation::CurveRole::general || one->role == articulation::CurveRole::specific;
    return {&one->view, &one->line, lasso};
  }
  return {};
}

/// The line on the model: where it meets the surface there, elsewhere as deep as that is in the mean.
std::vector<ModelPoint> on_model(PosedSurface& surface, const document::View& view, const std::vector<PxPoint>& line) {
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  if (!camera) return {};
  std::vector<std::optional<double>> depths;
  double sum = 0;
  std::size_t hits = 0;
  for (const PxPoint& px : line) {
    const auto hit = surface.pick(*camera, px);
    const geometry::Ray ray = camera->ray(px);
    depths.push_back(hit ? std::optional(camera->depth(ray.origin + ray.direction * hit->distance)) : std::nullopt);
    if (hit) sum += *depths.back();
    if (hit) ++hits;
  }
  const double usual = hits > 0 ? sum / static_cast<double>(hits) : camera->depth(view.camera.look_at);
  std::vector<ModelPoint> points;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const geometry::Ray ray = camera->ray(line[i]);
    const double a_unit = camera->depth(ray.origin + ray.direction);
    points.push_back(ray.origin + ray.direction * (depths[i].value_or(usual) / a_unit));
  }
  return points;
}

std::vector<PxPoint> seen(std::span<const ModelPoint> points, const document::View& view) {
  std::vector<PxPoint> line;
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  for (const ModelPoint& point : points) {
    const auto px = camera ? camera->project(point) : std::nullopt;
    if (px) line.push_back(*px);
  }
  return line;
}

double length_of(std::span<const PxPoint> line) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) sum += geometry::distance(line[i], line[i + 1]);
  return sum;
}

/// Commands that draw a line, which a step that wants another one takes back.
bool draws(std::string_view command) {
  return command == "draw_reference" || command == "draw_target" || command == "sketch_curve" ||
         command == "draw_constraint" || command == "pin" || command == "draw_face_line";
}

/// The control that was sketched last; empty: there is none.
std::string last_control(const document::Document& document) {
  const auto& deformers = document.model->deformers;
  return deformers && deformers->size() > 0 ? deformers->deformers().back()->sketch().name : std::string();
}

/// So many times nearer than all of the head the face fills a canvas; brows and mouth lie about the head's middle.
constexpr int k_times_nearer = 4;

/// The tool that draws what a command draws.
drawing::ToolKind tool_for(const Command& command) {
  if (command.holds<document::SketchCurve>()) return drawing::ToolKind::articulate;
  return drawing::ToolKind::pose;
}

}  // namespace

/// On a face as large as there is room.
void TourGuide::bring_into_sight(std::span<const ModelPoint> line) {
  const auto camera = geometry::Camera::make(parts_.canvas.view().camera, parts_.canvas.view().viewport);
  const auto hidden = [&](const ModelPoint& point) {
    const auto px = camera ? camera->project(point) : std::nullopt;
    return !px || !parts_.canvas.free_area().holds(*px);
  };
  if (std::none_of(line.begin(), line.end(), hidden)) return;
  parts_.actions.run(Action::frame_all);
  for (int i = 0; i < k_times_nearer; ++i) parts_.actions.run(Action::zoom_in);
}

void TourGuide::begin(Tour tour) {
  tour_ = std::move(tour);
  begun_.clear();
  ghost_.clear();
  // What would be done besides is not of the tour.
  parts_.panels.shown = true;
  parts_.panels.poses_tab = parts_.panels.controls_tab = false;
  parts_.panels.own.of<TimelineShown>() = {};
  parts_.playback.while_drawing() = {};
  parts_.playback.loop() = {};
  parts_.playback.place_cursor(0);
  parts_.actions.run(Action::frame_all);
  for (int i = 0; i < k_times_nearer; ++i) parts_.actions.run(Action::zoom_in);
  begin_step(parts_.editing.editor().history().undo_count());
}

void TourGuide::begin_step(std::size_t commands) {
  begun_.push_back(commands);
  again_.clear();
  ghost_ = line_of(step());
  ghost_before_ = step() > 0 ? line_of(step() - 1) : std::vector<ModelPoint>();
  const Command* command = wanted();
  if (command == nullptr) return;
  bring_into_sight(ghost_);
  if (command->holds<document::SetParameters>()) parts_.panels.controls_tab = true;
}

std::vector<ModelPoint> TourGuide::line_of(std::size_t step) const {
  if (step >= tour_->steps.size() || !tour_->steps[step].wanted) return {};
  const Drawn drawn = drawn_by(*tour_->steps[step].wanted);
  return drawn.line != nullptr ? on_model(parts_.canvas.surface(), *drawn.view, *drawn.line)
                               : std::vector<ModelPoint>();
}

const Command* TourGuide::wanted() const {
  if (done() || !tour_->steps[step()].wanted) return nullptr;
  return &*tour_->steps[step()].wanted;
}

bool TourGuide::ghost_closed() const {
  const Command* command = wanted();
  return command != nullptr && drawn_by(*command).lasso;
}

std::optional<double> TourGuide::asked_time() const {
  const Command* command = wanted();
  const auto* to = command != nullptr ? command->get_if<document::GoToTime>() : nullptr;
  return to != nullptr ? std::optional(to->time_s) : std::nullopt;
}

std::string TourGuide::pointed() const {
  if (done()) return {};
  const TourStep& due = tour_->steps[step()];
  if (due.press) return std::string(*due.press == Action::play ? "Play" : info(*due.press).label);
  const Command& command = *due.wanted;
  if (drawn_by(command).line != nullptr) {
    const drawing::ToolKind kind = tool_for(command);
    if (parts_.editing.editor().tool().kind == kind) return {};
    return std::string(info(kind == drawing::ToolKind::pose ? Action::tool_pose : Action::tool_articulate).label);
  }
  if (command.holds<document::BeginDeformer>()) return std::string(info(Action::tool_articulate).label);
  if (command.holds<document::SetKey>()) return std::string(info(Action::key_pose).label);
  if (command.holds<document::GoToTime>()) return "tour time";
  if (command.holds<document::SetParameters>()) return "slider " + last_control(parts_.editing.document());
  return {};
}

std::string TourGuide::says() const {
  if (done()) return tour_->ends;
  const TourStep& due = tour_->steps[step()];
  // A line that another tool would draw is told before it is drawn.
  if (due.wanted && drawn_by(*due.wanted).line != nullptr && !pointed().empty())
    return "Press " + pointed() + " first. Then: " + due.says;
  return due.says;
}

std::optional<std::size_t> TourGuide::given() const {
  const Command* command = wanted();
  if (command == nullptr) return std::nullopt;
  const auto& history = parts_.editing.editor().history();
  const std::string_view name = document::name_of(*command);
  for (std::size_t i = begun_.back(); i < history.undo_count(); ++i) {
    if (history.called_step(i).name == name) return i;
  }
  return std::nullopt;
}

TourGuide::Answer TourGuide::judge_drawn() const {
  const Command& command = *wanted();
  const Drawn drawn = drawn_by(command);
  const document::Document& document = parts_.editing.document();
  document::View view;
  std::vector<PxPoint> line;
  double within = k_feature_px;
  std::span<const ModelPoint> from;
  if (command.holds<document::DrawReference>()) {
    const auto last = std::find_if(document.curves.rbegin(), document.curves.rend(),
                                   [](const auto& curve) { return curve->role == document::PoseCurveRole::reference; });
    if (last == document.curves.rend()) return {};
    view = parts_.editing.editor().view();
    std::vector<ModelPoint> points;
    for (std::size_t i = 0; i < (*last)->points.size(); ++i) {
      points.emplace_back(parts_.canvas.surface().at((*last)->points[i]));
      // Where the pen was, and not where the sheet is that the line sticks to.
      if (i < (*last)->aside.size()) points.back() += (*last)->aside[i];
    }
    line = seen(points, view);
  } else if (command.holds<document::DrawTarget>()) {
    const auto last = std::find_if(document.curves.rbegin(), document.curves.rend(),
                                   [](const auto& curve) { return curve->target.has_value(); });
    if (last == document.curves.rend()) return {};
    view = (*last)->target->view;
    line = (*last)->target->line;
    within = k_target_px;
    from = ghost_before_;
  } else if (const auto* sketched = command.get_if<document::SketchCurve>()) {
    const std::string control = last_control(document);
    const bool target = sketched->role == articulation::CurveRole::target;
    if (target == (document.pending != nullptr)) return {false, "That was another line of the control"};
    if (target && control.empty()) return {};
    const articulation::Sketch& sketch =
        target ? document.model->deformers->deformers().back()->sketch() : document.pending->sketch;
    view = {target ? sketch.target_camera.value_or(sketch.camera) : sketch.camera, sketch.viewport};
    line = target                                               ? sketch.target
           : sketched->role == articulation::CurveRole::general ? sketch.general
                                                                : sketch.specific;
    within = target ? k_target_px : k_lasso_px;
  }
  const auto asked = seen(ghost_, view);
  const auto before = seen(from, view);
  if (line.empty() || asked.empty()) return {false, "That was too short for a line: draw it again"};
  // Of a line that is shown smaller the same share.
  const double scale = length_of(asked) / std::max(1.0, length_of(*drawn.line));
  const LineJudgement judgement = judge_line(line, {asked, before, within * scale, drawn.lasso});
  return {judgement.near, judgement.again};
}

std::string TourGuide::why_not(const std::vector<PxPoint>& stroke) const {
  const Command* command = wanted();
  const Drawn drawn = command == nullptr ? Drawn{} : drawn_by(*command);
  if (drawn.line == nullptr) return {};
  if (const std::string tool = pointed(); !tool.empty())
    return "That was another tool: press " + tool + ", then draw along the dashed line";
  const document::View& view = parts_.editing.editor().view();
  const auto asked = seen(ghost_, view);
  if (asked.empty() || stroke.empty()) return {};
  const double scale = length_of(asked) / std::max(1.0, length_of(*drawn.line));
  return judge_line(stroke, {asked, {}, k_feature_px * scale, drawn.lasso}).again;
}

TourGuide::Answer TourGuide::judge() const {
  const Command& command = *wanted();
  const document::Document& document = parts_.editing.document();
  if (drawn_by(command).line != nullptr) return judge_drawn();
  if (const auto* to = command.get_if<document::GoToTime>()) {
    const int rate = parts_.playback.rate();
    if (std::abs(document.time_s - to->time_s) <= k_near_s) return {true, {}};
    return {false,
            "That is frame " + frame_text(document.time_s, rate) + ": go to frame " + frame_text(to->time_s, rate),
            false};
  }
  if (const auto* set = command.get_if<document::SetParameters>()) {
    const auto number = rig::find_parameter(document.model->rig->parameters(), last_control(document));
    if (!number) return {false, "The control is gone: Undo brings it back", false};
    const rig::Parameter& parameter = document.model->rig->parameters()[*number];
    const double left = set->values.front().value - document.pose[*number];
    if (std::abs(left) <= k_pulled * (parameter.maximum - parameter.minimum)) return {true, {}};
    return {false, left < 0 ? "Further to the left" : "Further to the right", false};
  }
  if (const auto* key = command.get_if<document::SetKey>(); key != nullptr && key->time_s > 0) {
    const auto& keys = document.timeline->keys;
    const bool later = keys.size() > 1 && keys.back().time_s > k_near_s;
    return {later, later ? ""
                         : "That keyed the first moment again: go to frame " +
                               frame_text(key->time_s, parts_.playback.rate()) + " before"};
  }
  return {true, {}};
}

void TourGuide::follow() {
  if (!tour_) return;
  const EditingSession& editing = parts_.editing;
  if (parts_.files.path() != tour_->model || parts_.player.trace) return leave();
  const auto& history = editing.editor().history();
  if (const replay::DrawnStroke* stroke = editing.session().pens().current(); stroke != nullptr) {
    stroke_.clear();
    for (const auto& sample : stroke->samples) {
      if (stroke->on_canvas) stroke_.push_back(sample.position);
    }
    before_stroke_ = history.undo_count();
    return;
  }
  if (editing.shown().live().active()) return;
  // A line that the tool could make nothing of leaves no step to look at.
  const auto stroke = std::exchange(stroke_, {});
  if (!stroke.empty() && history.undo_count() == before_stroke_) {
    if (const std::string why = why_not(stroke); !why.empty()) again_ = why;
  }
  // The tour's own card is laid out after its first step has begun.
  if (step() == 0 && history.undo_count() == begun_.front()) bring_into_sight(ghost_);
  // Whoever takes back a step of the tour does it again.
  while (begun_.size() > 1 && history.undo_count() < begun_.back()) {
    begun_.pop_back();
    const std::size_t again = begun_.back();
    begun_.pop_back();
    begin_step(std::min(again, history.undo_count()));
  }
  while (!done()) {
    if (const auto& press = tour_->steps[step()].press) {
      if (*press == Action::play && !parts_.playback.playing()) return;
      begin_step(history.undo_count());
      continue;
    }
    const auto found = given();
    if (!found) {
      bool other = false;
      for (std::size_t i = begun_.back(); i < history.undo_count(); ++i)
        other = other || draws(history.called_step(i).name);
      if (!other) return;
      const std::string tool = pointed();
      parts_.playback.go_to_step(begun_.back());
      again_ = "Not quite, so it was undone" + (tool.empty() ? std::string() : ": press " + tool + " first");
      return;
    }
    const Answer answer = judge();
    if (!answer.right) {
      if (answer.taken_back) parts_.playback.go_to_step(begun_.back());
      again_ = answer.again;
      return;
    }
    begin_step(*found + 1);
  }
}

void TourGuide::drag_beside() {
  if (!tour_ || ghost_.empty() || !pointed().empty()) return;
  again_ = "That began beside the picture, where nothing is drawn: draw along the dashed line";
}

void TourGuide::skip() {
  if (!tour_ || done() || parts_.editing.session().pens().current() != nullptr) return;
  const TourStep due = tour_->steps[step()];
  again_.clear();
  if (due.press) return parts_.actions.run(*due.press);
  const document::Document& document = parts_.editing.document();
  if (due.wanted->holds<document::BeginDeformer>()) return parts_.actions.run(Action::tool_articulate);
  if (due.wanted->holds<document::SetKey>()) return parts_.actions.run(Action::key_pose);
  if (const auto* to = due.wanted->get_if<document::GoToTime>()) return parts_.playback.go_to(to->time_s);
  Command command = *due.wanted;
  if (auto* one = command.get_if<document::SetParameters>()) {
    if (!one->values.empty()) one->values.front().name = last_control(document);
  }
  // Drawn as the user sees it, so that what comes after it fits.
  const document::View& view = parts_.editing.editor().view();
  const auto line = seen(ghost_, view);
  if (auto* one = command.get_if<document::DrawReference>()) *one = {view, line};
  if (auto* one = command.get_if<document::SketchCurve>()) {
    one->view = view;
    one->line = line;
  }
  if (auto* one = command.get_if<document::DrawTarget>()) {
    const auto waits = std::find_if(document.curves.begin(), document.curves.end(), [](const auto& curve) {
      return curve->role == document::PoseCurveRole::reference && !curve->target;
    });
    if (waits == document.curves.end()) return;
    *one = {(*waits)->id, view, line, {}};
  }
  parts_.editing.perform(command);
}

}  // namespace penpose::app
