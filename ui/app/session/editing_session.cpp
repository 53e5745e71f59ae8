#include "ui/app/session/editing_session.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/document/drawing/pose_problem.h"
#include "core/intent/solve.h"
#include "ui/app/session/kept_line.h"
#include "ui/app/view/user_messages.h"

namespace penpose::app {

using replay::PenMoment;

namespace {

/// Strokes of these tools are drawn on the model at rest.
bool sketches(const drawing::Tool& tool) {
  return tool.kind == drawing::ToolKind::articulate || tool.kind == drawing::ToolKind::redraw ||
         tool.kind == drawing::ToolKind::between;
}

/// Whether a line of a session brings the face to a target.
bool solves(const replay::SessionLine& line) {
  const auto* performed = std::get_if<replay::Performed>(&line);
  if (performed == nullptr) return std::holds_alternative<replay::TabletGone>(line);
  return std::holds_alternative<document::DragTarget>(performed->command) ||
         std::holds_alternative<document::DrawTarget>(performed->command) ||
         std::holds_alternative<document::PullTarget>(performed->command) ||
         std::holds_alternative<document::SolvePose>(performed->command);
}

/// The curve that has another target than before; null: none.
document::CurveId new_target(const document::Document& before, const document::Document& after) {
  for (const auto& curve : after.curves) {
    const document::PoseCurve* was = document::find_curve(before, curve->id);
    if (curve->target && (was == nullptr || was->target != curve->target)) return curve->id;
  }
  return {};
}

}  // namespace

EditingSession::EditingSession(Clock clock, Tell tell, const decode::TabletTable* own)
    : clock_(std::move(clock)), tell_(std::move(tell)), own_(own) {}

void EditingSession::forget() {
  follow_.end();
  sketch_.end();
  preview_.reset();
  staged_.reset();
  mirrored_.reset();
  joined_.clear();
  habits_ = {};
  held_.reset();
  held_pull_between_.reset();
  movements_.clear();
  stroke_seen_ = false;
  live_.reset();
}

void EditingSession::resume(replay::Session session, replay::SessionWriter* writer, std::int64_t last_us) {
  forget();
  began_us_ = clock_() - last_us;
  live_ = std::make_unique<replay::LiveSession>(std::move(session), writer, last_us);
  live_->connect(0, replay::virtual_pen_identity());
  set_tool(editor().tool());
  saved_revision_ = revision_++;
}

void EditingSession::open(document::Document document, replay::SessionWriter* writer, const std::string& path) {
  forget();
  began_us_ = clock_();
  live_ = std::make_unique<replay::LiveSession>(std::move(document), writer, path, own_);
  live_->connect(0, replay::virtual_pen_identity());
  set_tool({});
  saved_revision_ = ++revision_;
}

bool EditingSession::act(const replay::SessionLine& line) {
  const document::Document before = document();
  const std::size_t count = editor().history().undo_count();
  const base::Status status = live_->act(line, now());
  if (std::holds_alternative<replay::Performed>(line) && editor().history().undo_count() > count)
    joined_.performed(count, joins_);
  after_steps(before, solves(line));
  if (!status && live_->session().steps().empty()) tell_(message_of(status.error()), true);
  return status.ok();
}

void EditingSession::after_steps(const document::Document& before, bool solved) {
  const auto steps = live_->session().steps();
  if (steps.empty()) return;
  for (const auto& step : steps) {
    if (step.status) continue;
    // A stroke that means nothing does no harm.
    const base::Error& error = step.status.error();
    tell_(step.is_stroke ? message_of_stroke(error, editor().tool(), before) : message_of(error), !step.is_stroke);
  }
  const bool any = std::any_of(steps.begin(), steps.end(), [](const auto& step) { return step.status.ok(); });
  if (!any) return;
  ++revision_;
  const auto parameters = document().model->rig->parameters();
  const bool same_rig = before.model == document().model;
  const document::CurveId drawn = new_target(before, document());
  if (!same_rig || (before.pose == document().pose && !drawn)) return;
  movements_.clear();
  left_px_ = -1;
  // Only a stroke finds parameters; what a slider or the timeline sets is known.
  if (!solved) return;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const double by = document().pose[i] - before.pose[i];
    if (std::abs(by) >= 0.005 * (parameters[i].maximum - parameters[i].minimum)) {
      const bool at_limit = document().pose[i] == parameters[i].minimum || document().pose[i] == parameters[i].maximum;
      movements_.push_back({parameters[i].name, by, at_limit && document().pose[i] != parameters[i].rest});
    }
  }
  std::stable_sort(movements_.begin(), movements_.end(),
                   [](const Movement& a, const Movement& b) { return std::abs(a.by) > std::abs(b.by); });
  solved_revision_ = revision_;
  solved_curve_ = drawn;
  measure_left();
}

void EditingSession::tell_of_cut(const document::Document& before, const replay::DrawnStroke& drawn) {
  constexpr double k_most_of_it = 0.85;
  for (const auto& curve : document().curves) {
    if (curve->target || curve->points.size() < 2 || document::find_curve(before, curve->id) != nullptr) continue;
    const double kept = kept_share(document(), *curve, drawn.view, drawn.samples);
    if (kept >= k_most_of_it) continue;
    tell_("Only " + std::to_string(static_cast<int>(100 * kept)) +
              " % of the line was kept, the rest lies off that part of the surface: undo, and draw along one part, or "
              "from nearer",
          false);
  }
}

void EditingSession::measure_left() {
  document::Document last = document();
  // The target that was drawn or dragged; the last one where all were solved again.
  auto drawn = std::find_if(last.curves.rbegin(), last.curves.rend(), [&](const auto& curve) {
    return curve->target && (!solved_curve_ || curve->id == solved_curve_);
  });
  if (drawn == last.curves.rend()) return;
  last.curves = {*drawn};
  const auto left = intent::left_at_start(*last.model->rig, follow_.whole_of(last), document::intent_problem(last));
  if (left && !left->empty()) left_px_ = left->front().px;
}

void EditingSession::say_outcome(std::string text) {
  movements_.clear();
  left_px_ = -1;
  outcome_ = std::move(text);
  outcome_revision_ = revision_;
}

bool EditingSession::last_is_solved() const { return left_px_ >= 0 && solved_revision_ == revision_; }

void EditingSession::lock(const std::vector<std::string>& names, bool locked) {
  const auto moved = [&](const std::string& name) {
    return std::any_of(movements_.begin(), movements_.end(), [&](const Movement& one) { return one.name == name; });
  };
  const document::PoseCurve* drawn = solved_curve_ ? document::find_curve(document(), solved_curve_) : nullptr;
  // What is given back may be what the stroke meant.
  const bool again = last_is_solved() && drawn != nullptr && drawn->target &&
                     (!locked || std::any_of(names.begin(), names.end(), moved));
  if (!again) {
    perform(document::LockParameters{names, locked});
    return;
  }
  const document::CurveId curve = drawn->id;
  const document::DrawnTarget target = *drawn->target;
  undo();
  if (!perform(document::LockParameters{names, locked})) {
    redo();
    return;
  }
  perform(document::DrawTarget{curve, target.view, target.line, target.pressure});
}

bool EditingSession::perform(const document::Command& command) {
  const document::Document before = document();
  const replay::SessionLine line = replay::Performed{command};
  if (!act(line)) return false;
  const bool poses = std::holds_alternative<document::SetParameters>(command) ||
                     std::holds_alternative<document::ResetParameters>(command) ||
                     std::holds_alternative<document::SuggestRest>(command) || solves(line);
  if (poses) follow_habits(before, solves(line));
  return true;
}

bool EditingSession::perform_with(const document::Command& command) {
  joins_ = true;
  const bool done = act(replay::Performed{command});
  joins_ = false;
  return done;
}

const std::vector<std::size_t>& EditingSession::two_sided_pairs() {
  if (paired_rig_ != document().model->rig) {
    paired_rig_ = document().model->rig;
    pairs_ = two_sided(side_pairs(paired_rig_->parameters()), follow_.whole_of(document()).partner);
  }
  return pairs_;
}

void EditingSession::follow_habits(const document::Document& before, bool solved) {
  const document::Document& now = document();
  if (before.model != now.model || before.pose == now.pose) return;
  // What the stroke moved is still what there is to say.
  const auto movements = movements_;
  const double left = left_px_;
  const bool tells = solved_revision_ == revision_;
  if (habits_.mirrors && solved) {
    const auto parameters = now.model->rig->parameters();
    const auto both =
        on_both_sides(parameters, two_sided_pairs(), before.pose, now.pose, document::weight_count(*now.model));
    if (both) perform_with(values_between(parameters, now.pose, *both));
  }
  if (habits_.keys) perform_with(document::SetKey{habits_.keys->first, habits_.keys->second});
  if (!tells) return;
  movements_ = movements;
  left_px_ = left;
  solved_revision_ = revision_;
}

void EditingSession::undo() {
  for (std::size_t n = can_undo(); n > 0; --n) act(replay::Undone{});
}

void EditingSession::redo() {
  for (std::size_t n = can_redo(); n > 0; --n) act(replay::Redone{});
}

void EditingSession::go_to_step(std::size_t commands) {
  while (editor().history().undo_count() > commands && act(replay::Undone{})) {
  }
  while (editor().history().undo_count() < commands && editor().history().redo_count() > 0 && act(replay::Redone{})) {
  }
}

void EditingSession::set_tool(drawing::Tool tool) {
  if (tool == editor().tool()) return;
  if (!sketches(tool)) sketch_.end();
  act(replay::ToolChosen{tool});
}

void EditingSession::set_view(const document::View& view) {
  if (view == editor().view()) return;
  act(replay::ViewChanged{view});
}

void EditingSession::set_tablet(int device, const replay::TabletSetting& setting) {
  act(replay::TabletSet{device, setting});
}

void EditingSession::place_pen(bool on_canvas) {
  if (session().pens().on_canvas() == on_canvas) return;
  act(replay::PenPlace{on_canvas});
}

std::vector<PenMoment> EditingSession::pen(const replay::VirtualPenState& state) {
  return report(0, replay::virtual_pen_report(state, editor().view().viewport));
}

void EditingSession::connect(int device, const decode::DeviceIdentity& identity) {
  const document::Document before = document();
  live_->connect(device, identity);
  after_steps(before);
}

void EditingSession::see_lights(int device, const decode::Lights& lights) { act(replay::LightsSeen{device, lights}); }

void EditingSession::disconnect(int device) { act(replay::TabletGone{device}); }

std::vector<PenMoment> EditingSession::report(int device, base::Bytes bytes) {
  return report_at(device, clock_(), bytes);
}

std::vector<PenMoment> EditingSession::report_at(int device, std::int64_t received_us, base::Bytes bytes) {
  const std::int64_t time_us = std::max<std::int64_t>(0, received_us - began_us_);
  const document::Document before = document();
  const std::size_t count = editor().history().undo_count();
  // What the report may end.
  std::optional<replay::DrawnStroke> drawn;
  if (session().pens().current() != nullptr) drawn = *session().pens().current();
  const auto moments = live_->report(device, time_us, bytes);
  std::vector<PenMoment> out(moments.begin(), moments.end());
  if (editor().history().undo_count() > count) joined_.performed(count, false);
  after_steps(before);
  if (drawn && session().pens().current() == nullptr) tell_of_cut(before, *drawn);
  // The stroke has ended: what is shown is the document again.
  if (session().pens().current() == nullptr) {
    follow_.end();
    sketch_.stroke_ended();
    stroke_seen_ = false;
    mirrored_.reset();
  }
  if (editor().history().undo_count() > count) follow_habits(before, true);
  return out;
}

void EditingSession::hold_target(std::optional<document::CurveId> curve, geometry::PxPoint by,
                                 const std::optional<PullHold>& pull) {
  held_pull_ = pull;
  held_ = curve;
  held_by_ = by;
  if (!held_) follow_.end();
  if (!held_) mirrored_.reset();
}

void EditingSession::hold_control_target(std::optional<document::PullBetween> pull) {
  if (held_pull_between_ == pull) return;
  if (!pull) sketch_.end();
  held_pull_between_ = std::move(pull);
  control_target_shown_ = false;
}

void EditingSession::follow_pen() {
  follow_stroke();
  mirrored_.reset();
  if (!habits_.mirrors || !follow_.active()) return;
  const auto& model = *document().model;
  mirrored_ = on_both_sides(model.rig->parameters(), two_sided_pairs(), document().pose, follow_.pose(),
                            document::weight_count(model));
}

void EditingSession::follow_stroke() {
  if (held_) {
    if (!follow_.active() || !(follow_.curve() == *held_)) {
      follow_.begin_drag(document(), *held_, editor().view(), held_pull_);
      followed_by_ = {};
    }
    // What is performed settles where the pen rests.
    if (staged_ || !(followed_by_ == held_by_)) follow_.drag(held_by_);
    followed_by_ = held_by_;
    return;
  }
  if (held_pull_between_) {
    if (!std::exchange(control_target_shown_, true)) sketch_.pull(document(), *held_pull_between_);
    return;
  }
  const replay::DrawnStroke* stroke = session().pens().current();
  if (stroke == nullptr || !stroke->on_canvas || stroke->eraser) {
    if (stroke == nullptr) follow_.end();
    if (sketches(editor().tool())) sketch_.show(document(), editor().tool());
    return;
  }
  if (!stroke_seen_) {
    stroke_seen_ = true;
    followed_ = 0;
    preview_.reset();
    follow_.begin(document(), editor().tool(), stroke->view, stroke->samples);
  }
  if (!staged_ && stroke->samples.size() == followed_) return;
  followed_ = stroke->samples.size();
  follow_.follow(stroke->samples);
  if (sketches(editor().tool())) {
    sketch_.follow(document(), editor().tool(), stroke->view, stroke->samples);
  }
}

const rig::Pose& EditingSession::shown_pose() const {
  if (follow_.active()) return staged_ ? *staged_ : pen_pose();
  if (preview_ && preview_->size() == document().pose.size() && !sketch_.model()) return *preview_;
  if (sketch_.pose()) return *sketch_.pose();
  return document().pose;
}

const std::shared_ptr<const document::Model>& EditingSession::shown_model() const {
  return sketch_.model() ? sketch_.model() : document().model;
}

}  // namespace penpose::app
