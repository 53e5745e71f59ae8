#include <algorithm>
#include <cmath>

#include "core/document/time/timeline.h"
#include "ui/app/action_rows.h"
#include "ui/app/app.h"
#include "ui/app/input/navigation.h"
#include "ui/app/view/said.h"

// What actions do, and the timeline and sliders in hand.

namespace penpose::app {
namespace {

constexpr double k_turn_degrees = 15;
constexpr double k_zoom = 0.85;
constexpr double k_same_moment_s = 1e-4;
constexpr double k_same_value = 1e-9;

drawing::ToolKind tool_of(Action action) {
  switch (action) {
    case Action::tool_pose:
      return drawing::ToolKind::pose;
    case Action::tool_oversketch:
      return drawing::ToolKind::oversketch;
    case Action::tool_constraint:
      return drawing::ToolKind::constraint;
    case Action::tool_pin:
      return drawing::ToolKind::pin;
    case Action::tool_erase:
      return drawing::ToolKind::erase;
    case Action::tool_articulate:
      return drawing::ToolKind::articulate;
    default:
      return drawing::ToolKind::none;
  }
}

}  // namespace

void App::do_action(Action action) {
  if (run_row(*this, action)) return;
  const auto turn = [&](double yaw, double pitch) {
    framed_ = false;
    if (!pen_is_drawing()) view_.camera = orbited(view_.camera, yaw, pitch);
  };
  const auto zoom = [&](double factor) {
    framed_ = false;
    if (!pen_is_drawing()) view_.camera = zoomed(view_, factor, free_.middle(), surface_.size());
  };
  const auto resize = [&](double by) {
    settings_.scale = std::clamp(settings_.scale + by, 0.5, 3.0);
    settings_changed();
  };
  switch (action) {
    case Action::tool_select:
    case Action::tool_pose:
    case Action::tool_oversketch:
    case Action::tool_constraint:
    case Action::tool_pin:
    case Action::tool_erase:
    case Action::tool_articulate: {
      drawing::Tool tool;
      tool.kind = tool_of(action);
      playing_ = false;
      workspace_.preview(std::nullopt);
      workspace_.set_tool(tool);
      panels_.curve_menu.reset();
      if (action == Action::tool_articulate && !workspace_.document().pending) {
        begin_control();
      }
      panels_.controls_tab =
          action == Action::tool_articulate || (action == Action::tool_select && panels_.controls_tab);
      break;
    }
    case Action::clear_curves:
      if (!workspace_.document().curves.empty()) workspace_.perform(document::ClearCurves{});
      break;
    case Action::delete_curve:
      if (highlighted_) workspace_.perform(document::DeleteCurve{*highlighted_});
      highlighted_.reset();
      break;
    case Action::keep_curve:
      if (highlighted_) workspace_.perform(document::KeepCurve{*highlighted_});
      break;
    case Action::reset_pose:
      workspace_.perform(document::ResetParameters{});
      break;
    case Action::suggest_rest:
      suggest_rest();
      break;
    case Action::cancel:
      if (panels_.radial) {
        panels_.radial.reset();
      } else if (panels_.dialog != Dialog::none) {
        if (panels_.dialog == Dialog::steps) {
          settings_.steps_seen = true;
          settings_changed();
        }
        // Work that was not saved is offered again at the next start.
        panels_.dialog = panels_.dialog == Dialog::recover && !settings_.steps_seen ? Dialog::steps : Dialog::none;
        panels_.file_name.clear();
        panels_.saves_first = false;
      } else if (offer_.open()) {
        offer_.dismiss(workspace_);
      } else if (playing_) {
        do_action(Action::play);
      } else if (workspace_.document().pending) {
        workspace_.perform(document::CancelDeformer{});
      }
      break;
    case Action::view_front:
      look_from(*render::find_viewpoint("front"));
      break;
    case Action::view_side:
      look_from(*render::find_viewpoint("side"));
      break;
    case Action::view_three_quarter:
      look_from(*render::find_viewpoint("three-quarter"));
      break;
    case Action::frame_all:
      frame_from(viewpoint_of(view_.camera));
      break;
    case Action::orbit_left:
      turn(-k_turn_degrees, 0);
      break;
    case Action::orbit_right:
      turn(k_turn_degrees, 0);
      break;
    case Action::orbit_up:
      turn(0, k_turn_degrees);
      break;
    case Action::orbit_down:
      turn(0, -k_turn_degrees);
      break;
    case Action::zoom_in:
      zoom(k_zoom);
      break;
    case Action::zoom_out:
      zoom(1 / k_zoom);
      break;
    case Action::wireframe:
      panels_.wireframe = !panels_.wireframe;
      break;
    case Action::key_pose:
      // A name that was given to this key stays.
      workspace_.perform(document::SetKey{panels_.time_s, name_of_key(panels_.time_s)});
      break;
    case Action::delete_key:
      workspace_.perform(document::DeleteKey{panels_.time_s});
      break;
    case Action::previous_key:
      step_key(-1);
      break;
    case Action::next_key:
      step_key(1);
      break;
    case Action::play:
      if (workspace_.document().timeline->keys.empty()) {
        tell("there is nothing to play yet: key a pose first");
      } else if (playing_) {
        playing_ = false;
        end_scrub();
      } else {
        playing_ = true;
        const LoopRange& loop = panels_.loop;
        const double end = loop.end_s(workspace_.document().timeline->keys.back().time_s);
        if (panels_.time_s >= end || panels_.time_s < loop.begin_s()) panels_.time_s = loop.begin_s();
        play_from_s_ = panels_.time_s;
        play_from_us_ = options_.clock();
      }
      break;
    case Action::onion_skin:
      panels_.onion_skin = !panels_.onion_skin;
      break;
    case Action::open:
      panels_.dialog = Dialog::open;
      break;
    case Action::recent:
      panels_.dialog = Dialog::recent;
      break;
    case Action::save:
      if (project_.empty()) {
        do_action(Action::save_as);
      } else if (const auto saved = save(project_); !saved) {
        tell(saved.error().line(project_), true);
      }
      break;
    case Action::save_as:
      panels_.file_name.clear();
      panels_.dialog = Dialog::save;
      break;
    case Action::export_as:
      panels_.file_name.clear();
      panels_.dialog = Dialog::export_as;
      break;
    case Action::panels:
      panels_.shown = !panels_.shown;
      break;
    case Action::fullscreen:
      fullscreen_ = !fullscreen_;
      break;
    case Action::theme:
      settings_.light = !settings_.light;
      settings_changed();
      break;
    case Action::larger:
      resize(0.25);
      break;
    case Action::smaller:
      resize(-0.25);
      break;
    case Action::help:
      panels_.dialog = Dialog::steps;
      break;
    case Action::quit:
      ask_to_quit();
      break;
    default:  // a row of action_rows.cpp
      break;
  }
}

void App::follow_time(double was_s) {
  // The playhead returns with the pose.
  if (workspace_.document().time_s != was_s) panels_.time_s = workspace_.document().time_s;
}

void App::undo() {
  const double was = workspace_.document().time_s;
  workspace_.preview(std::nullopt);
  if (workspace_.can_undo() > 0) workspace_.undo();
  follow_time(was);
}

void App::redo() {
  const double was = workspace_.document().time_s;
  workspace_.preview(std::nullopt);
  if (workspace_.can_redo() > 0) workspace_.redo();
  follow_time(was);
}

void App::go_to_step(std::size_t commands) {
  const double was = workspace_.document().time_s;
  workspace_.preview(std::nullopt);
  workspace_.go_to_step(commands);
  follow_time(was);
}

void App::go_to(double time_s) {
  playing_ = false;
  scrub(time_s);
  end_scrub();
}

void App::set_rate(int rate) {
  panels_.rate = settings_.rate = rate;
  settings_changed();
}

void App::follow_habits() {
  Habits habits;
  // What is played has its own commands.
  if (!player_ || !player_->is_session() || player_->finished()) {
    habits.mirrors = panels_.mirrors;
    if (panels_.auto_key && !playing_ && !performance_)
      habits.keys.emplace(panels_.time_s, name_of_key(panels_.time_s));
  }
  workspace_.set_habits(habits);
}

void App::suggest_rest() {
  if (offer_.open()) return offer_.dismiss(workspace_);
  if (pen_is_drawing()) return;
  playing_ = false;
  if (panels_.swing) set_swing(false);
  if (const auto asked = offer_.ask(workspace_); !asked) tell(said(asked.error()), true);
}

void App::step_key(int direction) {
  const auto& keys = workspace_.document().timeline->keys;
  const document::PoseKey* to = nullptr;
  for (const auto& key : keys) {
    if (direction < 0 && key.time_s < panels_.time_s - k_same_moment_s) to = &key;
    if (direction > 0 && key.time_s > panels_.time_s + k_same_moment_s && to == nullptr) to = &key;
  }
  if (to == nullptr) return;
  panels_.time_s = to->time_s;
  workspace_.preview(std::nullopt);
  workspace_.perform(document::GoToTime{panels_.time_s});
}

const document::PoseKey* App::key_at(double time_s) const {
  for (const auto& key : workspace_.document().timeline->keys) {
    if (std::abs(key.time_s - time_s) < k_same_moment_s) return &key;
  }
  return nullptr;
}

std::string App::name_of_key(double time_s) const {
  const auto* key = key_at(time_s);
  return key != nullptr ? key->name : std::string();
}

void App::name_key(const std::string& name) {
  const auto* key = key_at(panels_.time_s);
  if (key == nullptr) return;
  const document::SetKey named{key->time_s, name};
  // A key takes the pose as it is, and the name shall not change the pose.
  if (key->pose != document::SharedPose(workspace_.document().pose))
    workspace_.perform(document::GoToTime{named.time_s});
  workspace_.perform(named);
}

void App::move_key(double from_s, double to_s) {
  to_s = std::clamp(to_s, 0.0, document::k_latest_key_s);
  if (std::abs(from_s - to_s) < k_same_moment_s) return;
  if (!workspace_.perform(document::MoveKey{from_s, to_s})) return;
  panels_.time_s = to_s;
  workspace_.preview(std::nullopt);
  workspace_.perform(document::GoToTime{to_s});
}

void App::scrub(double time_s) {
  panels_.time_s = std::clamp(time_s, 0.0, document::k_latest_key_s);
  const auto& timeline = *workspace_.document().timeline;
  if (!timeline.keys.empty()) workspace_.preview(document::sample(timeline, panels_.time_s));
}

void App::end_scrub() {
  workspace_.preview(std::nullopt);
  const document::Document& document = workspace_.document();
  if (document.timeline->keys.empty()) return;
  // A pose that is on no key yet is carried along to where it shall be keyed, and not lost to a touch.
  const auto same = [&](const rig::Pose& pose) {
    return std::equal(pose.begin(), pose.end(), document.pose.begin(), document.pose.end(),
                      [](double a, double b) { return std::abs(a - b) < k_same_value; });
  };
  const auto& keys = document.timeline->keys;
  const bool kept = same(document::sample(*document.timeline, document.time_s)) ||
                    std::any_of(keys.begin(), keys.end(), [&](const auto& key) { return same(key.pose); });
  if (kept) {
    workspace_.perform(document::GoToTime{panels_.time_s});
  } else {
    tell("the pose is not on the timeline yet: Key puts it here; going to another key leaves it");
  }
}

void App::play_on() {
  const auto& keys = workspace_.document().timeline->keys;
  if (keys.empty()) {
    playing_ = false;
    workspace_.preview(std::nullopt);
    return;
  }
  const double begin = panels_.loop.begin_s();
  const double end = panels_.loop.end_s(keys.back().time_s);
  panels_.time_s = play_from_s_ + static_cast<double>(last_frame_us_ - play_from_us_) * 1e-6;
  if (end <= begin) {
    panels_.time_s = begin;
  } else if (panels_.time_s > end) {
    // Round and round, as an animator watches it.
    play_from_us_ = last_frame_us_;
    play_from_s_ = panels_.time_s = begin;
  }
  workspace_.preview(document::sample(*workspace_.document().timeline, panels_.time_s));
}

void App::preview_parameter(std::size_t parameter, double value) {
  rig::Pose pose = workspace_.document().pose;
  if (parameter >= pose.size()) return;
  pose[parameter] = value;
  workspace_.preview(std::move(pose));
}

void App::set_parameter(std::size_t parameter, double value) {
  workspace_.preview(std::nullopt);
  const auto parameters = workspace_.document().model->rig->parameters();
  if (parameter >= parameters.size()) return;
  const auto& one = parameters[parameter];
  workspace_.perform(document::SetParameters{{{one.name, std::clamp(value, one.minimum, one.maximum)}}});
}

}  // namespace penpose::app
