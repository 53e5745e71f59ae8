#include "ui/app/app.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <utility>

#include "core/base/numbers.h"
#include "ui/app/view/backdrop.h"
#include "ui/app/view/said.h"
#include "ui/app/view/toast_place.h"

namespace penpose::app {
namespace {

constexpr std::int64_t k_notice_us = 4'000'000;
constexpr std::size_t k_most_notices = 4;
constexpr double k_target_mm = 9;
constexpr double k_mm_per_inch = 25.4;
/// Sizes of what is hit by density, where the usual is 1.
constexpr double k_compact = 0.72;
constexpr double k_touch = 1.3;
/// Displays that say less or more than this say nonsense.
constexpr double k_least_dpi = 60;
constexpr double k_most_dpi = 600;
constexpr int k_playing_frame_ms = 16;
/// A wheel that rested for so long was meant to be where it is.
constexpr std::int64_t k_dial_rest_us = 400'000;
constexpr int k_dial_look_ms = 50;
constexpr int k_film_look_ms = 200;
constexpr std::int64_t k_longest_step_us = 200'000;

}  // namespace

App::App(AppOptions options)
    : options_(std::move(options)),
      settings_(load_settings(options_.folders.config)),
      workspace_(
          options_.clock, [this](std::string text, bool is_error) { tell(std::move(text), is_error); },
          options_.own_tablets) {
  if (!options_.folders.state.empty()) abandoned_ = abandoned_sessions(options_.folders.state + "/sessions");
  if (!abandoned_.empty()) {
    panels_.dialog = Dialog::recover;
  } else if (!settings_.steps_seen) {
    panels_.dialog = Dialog::steps;
  }
  // Before the first frame nobody knows where panels are.
  hits_.all = true;
  const char* home = std::getenv("HOME");
  panels_.folder = home != nullptr ? home : "/";
}

App::~App() {
  // What no memory was left for is offered at the next start, as after a crash.
  if (std::uncaught_exceptions() > 0) leaves_work_ = true;
  end_session();
}

void App::tell(std::string text, bool is_error) {
  const std::int64_t until = options_.clock() + k_notice_us;
  std::erase_if(notices_, [&](const Notice& one) { return one.text == text; });
  notices_.push_back({std::move(text), is_error, until});
  if (notices_.size() > k_most_notices) notices_.erase(notices_.begin());
}

void App::settings_changed() {
  if (const auto saved = save_settings(settings_, options_.folders.config); !saved) {
    tell("the settings cannot be kept: " + saved.error().line(options_.folders.config), true);
  }
}

double App::scale() const {
  const double dpi = dpi_ >= k_least_dpi && dpi_ <= k_most_dpi ? dpi_ : 96;
  return settings_.scale * dpi / 96;
}

double App::target_px() const {
  const double dpi = dpi_ >= k_least_dpi && dpi_ <= k_most_dpi ? dpi_ : 96;
  const double density = settings_.density == Density::compact ? k_compact
                         : settings_.density == Density::touch ? k_touch
                                                               : 1.0;
  return std::ceil(k_target_mm / k_mm_per_inch * dpi * std::max(1.0, settings_.scale) * density);
}

Area App::free_area() const { return free_; }

void App::set_free_area(const Area& area) {
  if (area == free_ || area.width() < 50 || area.height() < 50) return;
  free_ = area;
  if (framed_) frame_from(viewpoint_);
}

void App::advance() {
  const std::int64_t now = options_.clock();
  // A frame that took long does not make a recording jump: what its pen pressed has to be seen first.
  const bool shown = laid_out_ && last_frame_us_ != 0;
  const std::int64_t passed = !shown ? 0 : std::min(now - last_frame_us_, k_longest_step_us);
  last_frame_us_ = now;
  std::erase_if(notices_, [&](const Notice& one) { return one.until_us <= now; });
  if (tablet_near_ && !tablet_is_near()) tablet_near_ = false;
  commit_view();
  // Before the first frame nothing is known of what is hit, and keys would do nothing.
  if (player_ && shown) {
    // A frame that took long must not swallow the trace: what is due is handed on report by report.
    const bool agreed = !player_->divergence();
    player_->advance(workspace_, passed, *this);
    if (agreed && player_->divergence()) tell(replay::error_of(*player_->divergence()).line(), true);
    if (player_->is_session()) {
      // What its pen did to panels and tools is in its lines, in px of the window that it was drawn in.
      view_.camera = workspace_.editor().view().camera;
      show_new_deformer();
      if (player_->finished()) workspace_.set_tool(workspace_.editor().tool());
    }
  }
  hold_tools();
  follow_habits();
  follow_film();
  if (dial_ && !dial_touched_ && now - dial_us_ > k_dial_rest_us) end_dial();
  if (playing_) play_on();
  if (panels_.swing) swing();
  // What was said of a stroke is over with the next one that does something, and with another tool.
  const auto now_is = std::pair(workspace_.revision(), workspace_.editor().tool().kind);
  if (std::exchange(refused_at_, now_is) != now_is) {
    std::erase_if(notices_, [](const Notice& one) { return one.text.starts_with(k_nothing_changed); });
  }
  tell_new_doubts();
  workspace_.follow_pen();
  follow_performance();
  doubt_feature();
  offer_.follow(workspace_);
}

void App::begin_frame() {
  advance();
  surface_.update(workspace_.shown_model(), workspace_.shown_pose());
  CurveLook look;
  look.scale = static_cast<float>(scale());
  look.highlighted = highlighted_;
  look.onion_skin = panels_.onion_skin;
  // Lines of the moment in which a performance began are those that it pulls at.
  look.time_s = performance_ ? workspace_.document().time_s : panels_.time_s;
  look.window = window_;
  look.stabiliser = settings_.stabiliser;
  look.handles = workspace_.editor().tool().kind == drawing::ToolKind::none;
  if (goal_drag_) {
    look.goal = goal_drag_->first;
    look.dragged_by = at_ - goal_drag_->second;
    look.pulled = pull_;
  }
  if (panels_.controls_tab) look.deformer = panels_.deformer;
  if (target_drag_) {
    look.dragged = target_drag_->first;
    look.dragged_by = at_ - target_drag_->second;
    look.pulled = pull_;
  }
  tour_.follow(*this);
  curves_ = shown_curves(workspace_, surface_, look);
  tell_of_recording();
}

void App::tell_of_recording() {
  const bool broken = file_ && file_->writer().broken();
  if (broken == broken_told_ || !file_) return;
  broken_told_ = broken;
  if (!broken) return tell("this session is recorded again, with all that was drawn in between");
  tell("this session cannot be recorded now, and is kept in memory until it can: " +
           file_->writer().broken()->line(file_->path()),
       true);
}

int App::next_frame_ms() const {
  if (quit_) return 0;
  if (playing_ || performance_ || panels_.swing || !panel_pointer_.empty()) return k_playing_frame_ms;
  if (player_ && player_->playing()) {
    return static_cast<int>(std::clamp<std::int64_t>(player_->next_in_us() / 1000, 1, 1000));
  }
  if (dial_ && !dial_touched_) return k_dial_look_ms;
  if (film_) return k_film_look_ms;
  if (panels_.backdrop && panels_.backdrop->loading()) return k_playing_frame_ms;
  if (notices_.empty()) return -1;
  std::int64_t first = notices_.front().until_us;
  for (const Notice& one : notices_) first = std::min(first, one.until_us);
  // From then on it fades.
  const std::int64_t fades = first - static_cast<std::int64_t>(k_fade_s * 1e6);
  if (fades <= options_.clock()) return 2 * k_playing_frame_ms;
  first = fades;
  return static_cast<int>(std::max<std::int64_t>(1, (first - options_.clock()) / 1000 + 1));
}

void App::ask_to_open(const std::string& path) {
  if (!workspace_.unsaved()) return try_open(path);
  panels_.after_unsaved = path;
  panels_.dialog = Dialog::unsaved;
}

void App::ask_to_quit() {
  if (workspace_.unsaved() && panels_.dialog != Dialog::unsaved) {
    panels_.after_unsaved.clear();
    panels_.dialog = Dialog::unsaved;
    return;
  }
  quit_ = true;
}

void App::quit_at_once() {
  // A stroke that goes on ends here, as if the tablet had been unplugged.
  for (const int device : workspace_.session().pens().drawing()) workspace_.disconnect(device);
  leaves_work_ = workspace_.unsaved();
  quit_ = true;
}

std::string App::hint() const {
  const document::Document& document = workspace_.document();
  const drawing::Tool& tool = workspace_.editor().tool();
  if (performance_) return "Recording frame by frame: lift the pen to end the take";
  switch (tool.kind) {
    case drawing::ToolKind::pose:
      for (const auto& curve : document.curves) {
        if (curve->role == document::PoseCurveRole::reference && !curve->target) {
          return panels_.performs ? "Draw where this curve goes: time runs while the pen is down"
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
      if (panels_.performs) return "Pull at a target: time runs while the pen is down, and the face is keyed";
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
