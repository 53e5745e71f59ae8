#include "ui/app/app.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <utility>

#include "core/base/numbers.h"
#include "ui/app/view/backdrop.h"
#include "ui/app/view/toast_place.h"
#include "ui/app/view/user_messages.h"

namespace penpose::app {
namespace {

constexpr int k_playing_frame_ms = 16;
/// A wheel that rested for so long was meant to be where it is.
constexpr std::int64_t k_dial_rest_us = 400'000;
constexpr int k_dial_look_ms = 50;
constexpr int k_film_look_ms = 200;
constexpr std::int64_t k_longest_step_us = 200'000;

}  // namespace

App::App(AppOptions options)
    : options_(std::move(options)),
      notices_(options_.clock),
      preferences_(options_.folders.config, notices_),
      editing_(
          options_.clock, [this](std::string text, bool is_error) { notices_.tell(std::move(text), is_error); },
          options_.own_tablets),
      canvas_(editing_, preferences_, notices_, player_),
      controls_(editing_, notices_, canvas_, panels_),
      playback_(options_.clock, editing_, notices_, preferences_),
      keys_(editing_, notices_, playback_),
      performer_(editing_, notices_, playback_, player_),
      film_(editing_, notices_, canvas_, playback_) {
  if (!options_.folders.state.empty()) abandoned_ = abandoned_sessions(options_.folders.state + "/sessions");
  if (!abandoned_.empty()) {
    dialogs_.show(Dialog::recover);
  } else if (!preferences_.settings().steps_seen) {
    dialogs_.show(Dialog::steps);
  }
  touch_ = TouchGestures(4 * canvas_.scale());
  const char* home = std::getenv("HOME");
  dialogs_.state<FileChoice>().folder = home != nullptr ? home : "/";
}

App::~App() {
  // What no memory was left for is offered at the next start, as after a crash.
  if (std::uncaught_exceptions() > 0) leaves_work_ = true;
  end_session();
}

void App::advance() {
  const std::int64_t now = options_.clock();
  // A frame that took long does not make a recording jump: what its pen pressed has to be seen first.
  const bool shown = laid_out_ && last_frame_us_ != 0;
  const std::int64_t passed = !shown ? 0 : std::min(now - last_frame_us_, k_longest_step_us);
  last_frame_us_ = now;
  notices_.expire();
  if (tablet_near_ && !tablet_is_near()) tablet_near_ = false;
  canvas_.commit();
  // Before the first frame nothing is known of what is hit, and keys would do nothing.
  if (player_.trace && shown) {
    // A frame that took long must not swallow the trace: what is due is handed on report by report.
    const bool agreed = !player_.trace->divergence();
    player_.trace->advance(editing_, passed, *this);
    if (agreed && player_.trace->divergence())
      notices_.tell(replay::error_of(*player_.trace->divergence()).line(), true);
    if (player_.trace->is_session()) {
      // What its pen did to panels and tools is in its lines, in px of the window that it was drawn in.
      canvas_.show_played();
      controls_.show_new();
      if (player_.trace->finished()) editing_.set_tool(editing_.editor().tool());
    }
  }
  hold_tools();
  follow_habits();
  film_.follow();
  if (dial_ && !dial_touched_ && now - dial_us_ > k_dial_rest_us) end_dial();
  playback_.advance(now);
  controls_.swing(now);
  // What was said of a stroke is over with the next one that does something, and with another tool.
  const auto now_is = std::pair(editing_.revision(), editing_.editor().tool().kind);
  if (std::exchange(refused_at_, now_is) != now_is) {
    notices_.take_away([](const Notice& one) { return one.text.starts_with(k_nothing_changed); });
  }
  controls_.tell_new_doubts();
  editing_.follow_pen();
  performer_.follow(now);
  controls_.tell_doubt_of_feature();
  offer_.follow(editing_);
}

void App::do_action(Action action) { info(action).run(*this); }

void App::key(const KeyStroke& key) {
  const ActionInfo* action = action_of(key);
  if (action != nullptr) do_action(action->action);
}

void App::delete_highlighted() {
  if (highlighted_) editing_.perform(document::DeleteCurve{*highlighted_});
  highlighted_.reset();
}

void App::keep_highlighted() {
  if (highlighted_) editing_.perform(document::KeepCurve{*highlighted_});
}

void App::follow_habits() {
  Habits habits;
  // What is played has its own commands.
  if (!player_.plays_session()) {
    habits.mirrors = playback_.while_drawing().mirrors;
    if (playback_.while_drawing().auto_key && !playback_.playing() && !performer_.performing())
      habits.keys.emplace(playback_.time_s(), keys_.name_at(playback_.time_s()));
  }
  editing_.set_habits(habits);
}

void App::begin_frame() {
  advance();
  canvas_.surface().update(editing_.shown_model(), editing_.shown_pose());
  CurveLook look;
  look.scale = static_cast<float>(canvas_.scale());
  look.highlighted = highlighted_;
  look.onion_skin = canvas_.look().onion_skin;
  // Lines of the moment in which a performance began are those that it pulls at.
  look.time_s = performer_.performing() ? editing_.document().time_s : playback_.time_s();
  look.window = canvas_.window();
  look.stabiliser = preferences_.settings().stabiliser;
  look.handles = editing_.editor().tool().kind == drawing::ToolKind::none;
  if (control_drag_) {
    look.control_target = control_drag_->first;
    look.dragged_by = at_ - control_drag_->second;
    look.pulled = pull_;
  }
  if (panels_.controls_tab) look.deformer = controls_.selected();
  if (target_drag_) {
    look.dragged = target_drag_->first;
    look.dragged_by = at_ - target_drag_->second;
    look.pulled = pull_;
  }
  tour_.follow(*this);
  curves_ = shown_curves(editing_, canvas_.surface(), look);
  tell_of_recording();
}

void App::tell_of_recording() {
  const bool broken = file_ && file_->writer().broken();
  if (broken == broken_told_ || !file_) return;
  broken_told_ = broken;
  if (!broken) return notices_.tell("this session is recorded again, with all that was drawn in between");
  notices_.tell("this session cannot be recorded now, and is kept in memory until it can: " +
                    file_->writer().broken()->line(file_->path()),
                true);
}

int App::next_frame_ms() const {
  if (quit_) return 0;
  if (playback_.playing() || performer_.performing() || controls_.swings() || !panel_pointer_.empty())
    return k_playing_frame_ms;
  if (player_.trace && player_.trace->playing()) {
    return static_cast<int>(std::clamp<std::int64_t>(player_.trace->next_in_us() / 1000, 1, 1000));
  }
  if (dial_ && !dial_touched_) return k_dial_look_ms;
  if (film_.writes()) return k_film_look_ms;
  if (canvas_.look().backdrop && canvas_.look().backdrop->loading()) return k_playing_frame_ms;
  return notices_.next_frame_ms();
}

void App::ask_to_open(const std::string& path) {
  if (!editing_.unsaved()) return try_open(path);
  dialogs_.state<UnsavedWork>().then_opens = path;
  dialogs_.show(Dialog::unsaved);
}

void App::ask_to_quit() {
  if (editing_.unsaved() && dialogs_.open() != Dialog::unsaved) {
    dialogs_.state<UnsavedWork>().then_opens.clear();
    dialogs_.show(Dialog::unsaved);
    return;
  }
  quit_ = true;
}

void App::quit_at_once() {
  // A stroke that goes on ends here, as if the tablet had been unplugged.
  for (const int device : editing_.session().pens().drawing()) editing_.disconnect(device);
  leaves_work_ = editing_.unsaved();
  quit_ = true;
}

std::string App::hint() const {
  const document::Document& document = editing_.document();
  const drawing::Tool& tool = editing_.editor().tool();
  if (performer_.performing()) return "Recording frame by frame: lift the pen to end the take";
  switch (tool.kind) {
    case drawing::ToolKind::pose:
      for (const auto& curve : document.curves) {
        if (curve->role == document::PoseCurveRole::reference && !curve->target) {
          return playback_.while_drawing().performs ? "Draw where this curve goes: time runs while the pen is down"
                                                    : "Now draw where this curve should go: the face follows the pen";
        }
      }
      return "Draw along a feature of the face: a lip, a brow, an eyelid";
    case drawing::ToolKind::oversketch:
      return "Draw over the part of the last target that should change";
    case drawing::ToolKind::constraint:
      return "Draw along what should stay where it is";
    case drawing::ToolKind::pin:
      return "Touch a point that should stay where it is";
    case drawing::ToolKind::erase:
      return "Draw over curves to delete them";
    case drawing::ToolKind::articulate:
      if (!document.pending) return "1 of 4: draw around everything that a new control may move";
      switch (drawing::next_step(document, tool)) {
        case articulation::CurveRole::general:
          return "1 of 4: draw around everything that may move";
        case articulation::CurveRole::specific:
          return "2 of 4: draw around the part that moves fully";
        case articulation::CurveRole::reference:
          return "3 of 4: draw along the feature as it is now";
        case articulation::CurveRole::target:
          return tool.draw_reference ? "4 of 4: draw where the feature should go"
                                     : "4 of 4: draw where it should go (step 3, the feature, is found by itself)";
      }
      break;
    case drawing::ToolKind::none:
      if (playback_.while_drawing().performs)
        return "Pull at a target: time runs while the pen is down, and the face is keyed";
      return "Pull at a target, or move all of it by its middle; touch a curve, or the face to pick its control";
    case drawing::ToolKind::between:
      return "Draw where " + tool.deformer + " has the feature at " + base::format_fixed(tool.value, 2);
    case drawing::ToolKind::redraw:
      switch (tool.role) {
        case articulation::CurveRole::general:
          return "Draw around everything that " + tool.deformer + " may move";
        case articulation::CurveRole::specific:
          return "Draw around the part that " + tool.deformer + " moves fully";
        case articulation::CurveRole::reference:
          return "Draw along the feature that " + tool.deformer + " moves, as it is at rest";
        case articulation::CurveRole::target:
          return "Draw where " + tool.deformer + " should bring it";
      }
      break;
    default:
      break;
  }
  return {};
}

}  // namespace penpose::app
