#include "ui/app/session/editing_session.h"

#include <algorithm>
#include <utility>

#include "ui/app/session/kept_line.h"
#include "ui/app/view/user_messages.h"

namespace penpose::app {

namespace {

/// Whether a line of a session brings the face to a target.
bool solves(const replay::SessionLine& line) {
  const auto* performed = std::get_if<replay::Performed>(&line);
  if (performed == nullptr) return std::holds_alternative<replay::TabletGone>(line);
  return performed->command.holds<document::DragTarget>() || performed->command.holds<document::DrawTarget>() ||
         performed->command.holds<document::PullTarget>() || performed->command.holds<document::SolvePose>() ||
         performed->command.holds<document::TakeReading>() || performed->command.holds<document::DrawFaceLine>() ||
         performed->command.holds<document::NameFaceLine>() || performed->command.holds<document::LineIsFeature>();
}

/// Whether a line of a session goes to another moment and does nothing else: what is saved is the same there.
bool moves_in_time(const replay::SessionLine& line) {
  const auto* performed = std::get_if<replay::Performed>(&line);
  return performed != nullptr && performed->command.holds<document::GoToTime>();
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
  shown_.forget();
  steps_.forget();
  habits_ = {};
  last_ = {};
  live_.reset();
}

void EditingSession::resume(replay::Session session, replay::SessionWriter* writer, std::int64_t last_us) {
  forget();
  began_us_ = clock_() - last_us;
  live_ = std::make_unique<replay::LiveSession>(std::move(session), writer, last_us);
  live_->connect(0, replay::virtual_pen_identity());
  set_tool(editor().tool());
  moments_.begin(this->document());
  saved_revision_ = revision_++;
}

void EditingSession::open(document::Document document, replay::SessionWriter* writer, const std::string& path) {
  forget();
  began_us_ = clock_();
  live_ = std::make_unique<replay::LiveSession>(std::move(document), writer, path, own_);
  live_->connect(0, replay::virtual_pen_identity());
  set_tool({});
  moments_.begin(this->document());
  saved_revision_ = ++revision_;
}

SessionAside EditingSession::set_aside() {
  SessionAside aside{std::move(live_), steps_.take_joined(), moments_, began_us_, unsaved()};
  forget();
  return aside;
}

void EditingSession::take_up(SessionAside aside) {
  forget();
  live_ = std::move(aside.live);
  steps_.give_joined(std::move(aside.joined));
  moments_ = std::move(aside.moments);
  began_us_ = aside.began_us;
  saved_revision_ = ++revision_;
  if (aside.unsaved) ++revision_;
}

base::Status EditingSession::act_aside(SessionAside& aside, const replay::SessionLine& line) {
  return aside.live->act(line, clock_() - aside.began_us);
}

bool EditingSession::act(const replay::SessionLine& line) {
  const document::Document before = document();
  const std::size_t count = editor().history().undo_count();
  const base::Status status = live_->act(line, now());
  if (std::holds_alternative<replay::Performed>(line) && editor().history().undo_count() > count)
    steps_.performed(count, joins_);
  const bool stays_saved = !unsaved() && moves_in_time(line);
  after_steps(before, solves(line));
  if (stays_saved) mark_saved();
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
  moments_.follow(document());
  last_.grow_old();
  const bool same_rig = before.model == document().model;
  const document::CurveId drawn = new_target(before, document());
  const bool face_line = solved && document().face && document().face != before.face;
  if (!same_rig || (before.pose == document().pose && !drawn && !face_line)) return;
  last_.forget();
  // Only a stroke finds parameters; what a slider or the timeline sets is known.
  if (solved) last_.look_at(before, document(), drawn, shown_.whole_model());
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

bool EditingSession::perform(const document::Command& command) {
  const document::Document before = document();
  const replay::SessionLine line = replay::Performed{command};
  if (!act(line)) return false;
  const bool poses = command.holds<document::SetParameters>() || command.holds<document::ResetParameters>() ||
                     command.holds<document::SuggestRest>() || solves(line);
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
    pairs_ = two_sided(side_pairs(paired_rig_->parameters()), shown_.whole_model().partner);
  }
  return pairs_;
}

std::span<const document::ControlWords> EditingSession::words() {
  return words_.of(
      *document().model, [&]() -> const intent::WholeModel& { return shown_.whole_model(); },
      [&] { return features(); });
}

std::string EditingSession::words_of(const std::string& parameter) {
  const auto number = rig::find_parameter(document().model->rig->parameters(), parameter);
  return number ? words()[*number].text() : parameter;
}

void EditingSession::follow_habits(const document::Document& before, bool solved) {
  const document::Document& now = document();
  if (before.model != now.model || before.pose == now.pose) return;
  // What the stroke moved is still what there is to say.
  const LastStroke kept = last_;
  if (habits_.mirrors && solved) {
    const auto parameters = now.model->rig->parameters();
    const auto both =
        on_both_sides(parameters, two_sided_pairs(), before.pose, now.pose, document::weight_count(*now.model));
    if (both) perform_with(values_between(parameters, now.pose, *both));
  }
  if (habits_.keys) perform_with(document::SetKey{habits_.keys->first, habits_.keys->second});
  if (kept.is_fresh()) last_ = kept;
}

void EditingSession::set_tool(const drawing::Tool& tool) {
  if (tool == editor().tool()) return;
  if (!sketches(tool)) shown_.sketch().end();
  act(replay::ToolChosen{tool});
}

void EditingSession::set_view(const document::View& view) {
  if (view == editor().view()) return;
  act(replay::ViewChanged{view});
}

void lock_parameters(EditingSession& editing, const std::vector<std::string>& names, bool locked) {
  const LastStroke& last = editing.last_stroke();
  const auto moved = [&](const std::string& name) {
    const auto& all = last.movements();
    return std::any_of(all.begin(), all.end(), [&](const Movement& one) { return one.name == name; });
  };
  const document::PoseCurve* drawn = last.curve() ? document::find_curve(editing.document(), last.curve()) : nullptr;
  // What is given back may be what the stroke meant.
  const bool again = last.is_newest() && drawn != nullptr && drawn->target &&
                     (!locked || std::any_of(names.begin(), names.end(), moved));
  if (!again) {
    editing.perform(document::LockParameters{names, locked});
    return;
  }
  const document::CurveId curve = drawn->id;
  const document::DrawnTarget target = *drawn->target;
  editing.steps().undo();
  if (!editing.perform(document::LockParameters{names, locked})) {
    editing.steps().redo();
    return;
  }
  editing.perform(document::DrawTarget{curve, target.view, target.line, target.pressure});
}

}  // namespace penpose::app
