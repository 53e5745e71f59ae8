#include "ui/app/playback/sheet/overlap_offer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>

#include "ui/app/playback/frames.h"

namespace penpose::app {
namespace {

/// Baked keys are so near to the spring, as a share of the way that the control goes.
constexpr double k_bake_tolerance = 0.01;
/// A drawing moved a control by more than this share of its range.
constexpr double k_moved_share = 1e-4;

std::string frames_text(double frames) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", frames);
  return text;
}

}  // namespace

void OverlapOffer::begin() {
  if (editing_.pen_is_drawing()) return;
  std::map<std::size_t, std::pair<double, double>> spans;  // first and last key, by control
  for (const auto& [time_s, control] : keys_.selected().keys()) {
    const auto [span, is_new] = spans.try_emplace(control, time_s, time_s);
    span->second.second = time_s;
  }
  if (spans.empty())
    return notices_.tell("no keys are selected that could trail: touch a control's name in the sheet (T) first");
  playback_.stop();
  const document::Document& document = editing_.document();
  timeline_ = document.timeline;
  rig_ = document.model->rig;
  revision_ = editing_.revision();
  trailing_.clear();
  said_.clear();
  shows_ = false;
  to_draw_on_.reset();
  if (values_.leader && (*values_.leader >= document.pose.size() || spans.count(*values_.leader) > 0))
    values_.leader.reset();
  for (const auto& [control, span] : spans) {
    Trailing one;
    one.overlap.control = control;
    one.overlap.first_s = span.first;
    one.overlap.last_s = span.second;
    trailing_.push_back(std::move(one));
  }
  reckon();
}

void OverlapOffer::set(const OverlapValues& values) {
  if (values == values_) return;
  values_ = values;
  said_.clear();
  reckon();
}

void OverlapOffer::reckon() {
  const int rate = playback_.rate();
  for (Trailing& one : trailing_) {
    one.overlap.leader = values_.leader;
    one.overlap.delay_s = time_of_frame(values_.delay_frames, rate);
    one.overlap.amount = values_.amount;
    one.overlap.rate = rate;
    one.way = std::make_shared<document::LedWay>(*timeline_, rig_->parameters(), one.overlap);
    one.curve = one.way->trailed({time_of_frame(values_.period_frames, rate), values_.swing});
    one.keys = document::keys_of(*timeline_, one.overlap.control, one.overlap.last_s, one.curve, k_bake_tolerance);
  }
}

std::vector<std::size_t> OverlapOffer::leaders() const {
  std::vector<std::size_t> found;
  for (std::size_t p = 0; timeline_ && p < rig_->parameters().size(); ++p) {
    const bool trails =
        std::any_of(trailing_.begin(), trailing_.end(), [&](const Trailing& one) { return one.overlap.control == p; });
    const auto& keys = timeline_->keys;
    const bool moves = std::any_of(keys.begin(), keys.end(), [&](const document::PoseKey& key) {
      return key.controls.has(p) && key.pose[p] != keys.front().pose[p];
    });
    if (!trails && moves) found.push_back(p);
  }
  return found;
}

std::optional<double> OverlapOffer::value_at(std::size_t control, double time_s) const {
  const auto one = std::find_if(trailing_.begin(), trailing_.end(),
                                [&](const Trailing& trailing) { return trailing.overlap.control == control; });
  if (one == trailing_.end()) return std::nullopt;
  const auto& [times_s, values, joins] = one->curve;
  // Before it and, where it joins the control's curve, behind it nothing changes.
  if (time_s < times_s.front() || (joins && time_s > times_s.back()))
    return document::sample(*timeline_, control, time_s);
  const auto after = std::lower_bound(times_s.begin(), times_s.end(), time_s);
  if (after == times_s.begin() || after == times_s.end())
    return after == times_s.begin() ? values.front() : values.back();
  const auto i = static_cast<std::size_t>(after - times_s.begin());
  const double share = (time_s - times_s[i - 1]) / (times_s[i] - times_s[i - 1]);
  return values[i - 1] + share * (values[i] - values[i - 1]);
}

rig::Pose OverlapOffer::pose_at(double time_s) const {
  rig::Pose pose = document::pose_at(editing_.document(), time_s);
  for (const Trailing& one : trailing_) pose[one.overlap.control] = *value_at(one.overlap.control, time_s);
  return pose;
}

void OverlapOffer::show_by_drawing(bool on) {
  if (on == shows_ || !open()) return;
  if (on && !keyed())
    return notices_.tell("the pose here is not on the timeline yet: Key it first, so that drawing does not lose it");
  shows_ = on;
  // Going through time, the pose to draw on is none that could be lost.
  playback_.carry_poses(!on);
  if (!on) return take_back();
  playback_.stop();
  commands_ = editing_.editor().history().undo_count();
}

bool OverlapOffer::keyed() const {
  const document::Document& document = editing_.document();
  return document.pose == document::pose_at(document, document.time_s);
}

void OverlapOffer::pose_for_drawing() {
  posed_s_ = playback_.time_s();
  editing_.shown().preview(std::nullopt);
  if (editing_.document().time_s != posed_s_) editing_.perform(document::GoToTime{posed_s_});
  document::SetParameters pose;
  for (const Trailing& one : trailing_) {
    const std::size_t p = one.overlap.control;
    const double value = *value_at(p, posed_s_);
    if (value != editing_.document().pose[p]) pose.values.push_back({rig_->parameters()[p].name, value});
  }
  if (!pose.values.empty()) editing_.perform(pose);
  to_draw_on_ = editing_.document().pose;
  posed_commands_ = editing_.editor().history().undo_count();
  revision_ = editing_.revision();
}

void OverlapOffer::take_back() {
  if (!to_draw_on_) return;
  to_draw_on_.reset();
  editing_.shown().preview(std::nullopt);
  editing_.steps().go_to(commands_);
  // What could be brought back again goes with it.
  editing_.perform(document::GoToTime{playback_.time_s()});
  commands_ = editing_.editor().history().undo_count();
  revision_ = editing_.revision();
}

void OverlapOffer::look_at(const rig::Pose& drawn) {
  const auto parameters = rig_->parameters();
  const Trailing* moved = nullptr;
  double most = k_moved_share;
  for (const Trailing& one : trailing_) {
    const rig::Parameter& range = parameters[one.overlap.control];
    const double by = std::abs(drawn[one.overlap.control] - (*to_draw_on_)[one.overlap.control]);
    const double share = by / std::max(range.maximum - range.minimum, 1e-12);
    if (share <= most) continue;
    most = share;
    moved = &one;
  }
  if (moved == nullptr) {
    said_ = "What was drawn moves none of the controls that trail: draw at a part that they move.";
    return;
  }
  const int rate = playback_.rate();
  const double wanted = drawn[moved->overlap.control];
  const document::Spring now{time_of_frame(values_.period_frames, rate), values_.swing};
  const auto found = document::spring_through(*moved->way, now, posed_s_, wanted, rate);
  values_.period_frames = std::min(frame_of(found.spring.period_s, rate), k_most_period_frames);
  const std::string name = editing_.words()[moved->overlap.control].text();
  const std::string at = "frame " + frame_text(posed_s_, rate);
  reckon();
  char gap[32];
  std::snprintf(gap, sizeof gap, "%.3g", std::abs(found.value - wanted));
  said_ = found.passes
              ? name + " passes there at " + at + ": a swing of " + frames_text(values_.period_frames) + " frames."
              : "No stiffness brings " + name + " there by " + at + ": the nearest, " +
                    frames_text(values_.period_frames) + " frames, stays " + gap + " away. Another delay may.";
}

void OverlapOffer::follow_drawing() {
  const document::Document& document = editing_.document();
  if (to_draw_on_ && editing_.revision() != revision_) {
    const std::size_t commands = editing_.editor().history().undo_count();
    if (commands < posed_commands_) {
      // The artist took it back.
      commands_ = std::min(commands_, commands);
      take_back();
    } else if (document.time_s == posed_s_ && document.pose != *to_draw_on_) {
      look_at(document.pose);
      take_back();
    } else if (document.pose != *to_draw_on_ || document.time_s != posed_s_) {
      take_back();
    }
    revision_ = editing_.revision();
  }
  const bool still = !playback_.playing() && !playback_.scrubs();
  if (to_draw_on_ && still && playback_.time_s() != posed_s_) take_back();
  if (to_draw_on_ && still) {
    // Other values are seen, and drawn on, at once.
    const bool same = std::all_of(trailing_.begin(), trailing_.end(), [&](const Trailing& one) {
      return (*to_draw_on_)[one.overlap.control] == *value_at(one.overlap.control, posed_s_);
    });
    if (!same) take_back();
  }
  if (!to_draw_on_ && still) pose_for_drawing();
}

void OverlapOffer::follow() {
  if (!open()) return;
  const document::Document& document = editing_.document();
  const bool same = document.model->rig == rig_ && (document.timeline == timeline_ || *document.timeline == *timeline_);
  if (!same || (!shows_ && editing_.revision() != revision_ && !keyed())) return end();
  if (editing_.pen_is_drawing() || editing_.shown().live().active() || editing_.shown().face().active()) return;
  if (shows_) follow_drawing();
  revision_ = editing_.revision();
  if (!to_draw_on_ || playback_.playing() || playback_.scrubs()) editing_.shown().preview(pose_at(playback_.time_s()));
}

void OverlapOffer::bake() {
  if (!open()) return;
  if (shows_) show_by_drawing(false);
  const bool follows = keyed();
  const auto baked = std::exchange(trailing_, {});
  std::size_t keys = 0;
  bool first = true;
  for (const Trailing& one : baked) {
    const document::KeyPoses command{{rig_->parameters()[one.overlap.control].name}, one.keys.times_s, one.keys.values};
    if (!(std::exchange(first, false) ? editing_.perform(command) : editing_.perform_with(command))) break;
    keys += one.keys.times_s.size();
  }
  end();
  if (keys == 0) return;
  if (follows) editing_.perform_with(document::GoToTime{playback_.time_s()});
  notices_.tell("baked as " + std::to_string(keys) + " keys of " + std::to_string(baked.size()) +
                (baked.size() == 1 ? " control" : " controls"));
}

void OverlapOffer::dismiss() {
  if (!open()) return;
  if (shows_) show_by_drawing(false);
  end();
}

void OverlapOffer::end() {
  trailing_.clear();
  timeline_.reset();
  to_draw_on_.reset();
  if (std::exchange(shows_, false)) playback_.carry_poses(true);
  editing_.shown().preview(std::nullopt);
}

void OverlapOffer::forget() {
  if (open()) end();
  values_.leader.reset();
}

}  // namespace penpose::app
