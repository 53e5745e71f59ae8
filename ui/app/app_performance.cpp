#include <algorithm>
#include <string>
#include <utility>

#include "core/document/time/timeline.h"
#include "ui/app/app.h"
#include "ui/app/session/frames.h"

// The pen as a puppet's string: time runs while it holds a target, and what the face does is keyed.

namespace penpose::app {
namespace {

/// "mouthSmile_L, jawOpen and 3 more".
std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t k_most = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(k_most, names.size()); ++i) text += (i > 0 ? ", " : "") + names[i];
  if (names.size() > k_most) text += " and " + std::to_string(names.size() - k_most) + " more";
  return text;
}

}  // namespace

void App::follow_performance() {
  if (!performance_) {
    const bool plays_session = player_ && player_->is_session() && !player_->finished();
    if (!panels_.performs || !workspace_.live().active() || plays_session) return;
    playing_ = false;
    workspace_.preview(std::nullopt);
    panels_.time_s = on_frame(panels_.time_s, panels_.rate);
    performance_.emplace(panels_.time_s, panels_.rate, workspace_.document().pose);
    performed_steps_ = workspace_.editor().history().undo_count();
    play_from_s_ = panels_.time_s;
    play_from_us_ = last_frame_us_;
    return;
  }
  if (!workspace_.live().active()) {
    static_cast<void>(end_performance());
    return;
  }
  panels_.time_s = play_from_s_ + static_cast<double>(last_frame_us_ - play_from_us_) * 1e-6;
  if (panels_.loop.to_s && panels_.time_s > *panels_.loop.to_s) {
    play_from_us_ = last_frame_us_;
    play_from_s_ = panels_.time_s = panels_.loop.begin_s();
  }
  panels_.time_s = std::min(panels_.time_s, document::k_latest_key_s);
  const document::Document& document = workspace_.document();
  const rig::Pose& pen = workspace_.pen_pose();
  performance_->take(panels_.time_s, pen);
  const bool keyed = !document.timeline->keys.empty();
  workspace_.stage(
      performance_->over(keyed ? document::sample(*document.timeline, panels_.time_s) : document.pose, pen));
}

bool App::end_performance() {
  const Performance performance = *std::exchange(performance_, std::nullopt);
  workspace_.stage(std::nullopt);
  const document::Document& document = workspace_.document();
  const auto keys = performance.keys(document.model->rig->parameters(), document.pose);
  const bool any = keys && performance.frame_count() > 1;
  panels_.time_s = any ? performance.last_s() : document.time_s;
  if (!any) return false;
  // What a drawn target did to the pose belongs to it.
  const bool drawn = workspace_.editor().history().undo_count() > performed_steps_;
  if (!(drawn ? workspace_.perform_with(*keys) : workspace_.perform(*keys))) return true;
  workspace_.perform_with(document::GoToTime{panels_.time_s});
  const std::string keyed = std::to_string(performance.frame_count()) + " frames are keyed: " + listed(keys->names);
  workspace_.say_outcome(keyed);
  tell(keyed + "; Undo takes the take back");
  return true;
}

}  // namespace penpose::app
