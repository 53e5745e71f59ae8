#include "ui/app/playback/playback.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/document/time/timeline.h"
#include "ui/app/playback/frames.h"

namespace penpose::app {
namespace {

constexpr double k_same_time_s = 1e-4;
constexpr double k_same_value = 1e-9;

}  // namespace

Playback::Playback(Clock clock, EditingSession& editing, Notices& notices, Preferences& preferences)
    : clock_(std::move(clock)), editing_(editing), notices_(notices), preferences_(preferences) {}

void Playback::begin() {
  playing_ = scrubs_ = false;
  carries_ = true;
  while_drawing_.performs = false;
  time_s_ = editing_.document().time_s;
  std::vector<double> moments;
  for (const auto& key : editing_.document().timeline->keys) moments.push_back(key.time_s);
  rate_ = rate_of(moments).value_or(preferences_.settings().rate);
  loop_ = {};
}

void Playback::take_over() {
  scrubs_ = false;
  carries_ = true;
  const document::Document& document = editing_.document();
  const bool elsewhere = std::abs(document.time_s - time_s_) > k_same_time_s;
  if (!playing_ && elsewhere && !document.timeline->keys.empty()) go_to(time_s_);
}

void Playback::play_or_stop() {
  if (last_s() <= 0 && editing_.document().timeline->keys.empty()) {
    notices_.tell("there is nothing to play yet: key a pose first");
  } else if (playing_) {
    stop();
  } else {
    playing_ = true;
    const double end = loop_.end_s(last_s());
    if (time_s_ >= end || time_s_ < loop_.begin_s()) time_s_ = loop_.begin_s();
    play_from_s_ = time_s_;
    play_from_us_ = clock_();
  }
}

double Playback::settled(double time_s) const {
  const auto& keys = editing_.document().timeline->keys;
  const bool on_key = std::any_of(keys.begin(), keys.end(),
                                  [&](const auto& key) { return std::abs(key.time_s - time_s) < k_same_time_s; });
  return on_key ? time_s : on_frame(time_s, rate_);
}

void Playback::stop() {
  if (!std::exchange(playing_, false)) return;
  time_s_ = settled(time_s_);
  // A pen that draws has begun on the pose that there is.
  if (!editing_.pen_is_drawing()) end_scrub();
}

void Playback::follow_time(double was_s) {
  // The playhead returns with the pose.
  if (editing_.document().time_s != was_s) time_s_ = editing_.document().time_s;
}

void Playback::undo() {
  const double was = editing_.document().time_s;
  editing_.shown().preview(std::nullopt);
  if (editing_.steps().can_undo() > 0) editing_.steps().undo();
  follow_time(was);
}

void Playback::redo() {
  const double was = editing_.document().time_s;
  editing_.shown().preview(std::nullopt);
  if (editing_.steps().can_redo() > 0) editing_.steps().redo();
  follow_time(was);
}

void Playback::go_to_step(std::size_t commands) {
  const double was = editing_.document().time_s;
  editing_.shown().preview(std::nullopt);
  editing_.steps().go_to(commands);
  follow_time(was);
}

void Playback::go_to(double time_s) {
  playing_ = false;
  scrub(settled(time_s));
  end_scrub();
}

void Playback::set_rate(int rate) {
  rate_ = preferences_.settings().rate = rate;
  preferences_.changed();
}

void Playback::set_speed(double speed) {
  if (playing_) {
    play_from_s_ = time_s_;
    play_from_us_ = clock_();
  }
  speed_ = speed;
}

void Playback::step_key(int direction) {
  const auto& keys = editing_.document().timeline->keys;
  const document::PoseKey* to = nullptr;
  for (const auto& key : keys) {
    if (direction < 0 && key.time_s < time_s_ - k_same_time_s) to = &key;
    if (direction > 0 && key.time_s > time_s_ + k_same_time_s && to == nullptr) to = &key;
  }
  if (to == nullptr) return;
  time_s_ = to->time_s;
  editing_.shown().preview(std::nullopt);
  editing_.perform(document::GoToTime{time_s_});
}

void Playback::scrub(double time_s) {
  time_s_ = std::clamp(time_s, 0.0, document::k_latest_key_s);
  const document::Document& document = editing_.document();
  scrubs_ = !document.timeline->keys.empty();
  if (scrubs_) editing_.shown().preview(document::pose_at(document, time_s_));
}

std::optional<double> Playback::shown_moment() const {
  if (playing_) return std::nullopt;
  // A pose that is carried along the timeline keeps the lines that it was drawn with.
  return scrubs_ ? time_s_ : editing_.document().time_s;
}

void Playback::end_scrub() {
  scrubs_ = false;
  editing_.shown().preview(std::nullopt);
  const document::Document& document = editing_.document();
  if (document.timeline->keys.empty()) return;
  // A pose that is on no key yet is carried along to where it shall be keyed, and not lost to a touch.
  const auto same = [&](const rig::Pose& pose) {
    return std::equal(pose.begin(), pose.end(), document.pose.begin(), document.pose.end(),
                      [](double a, double b) { return std::abs(a - b) < k_same_value; });
  };
  const auto& keys = document.timeline->keys;
  const bool kept = !carries_ || same(document::pose_at(document, document.time_s)) ||
                    std::any_of(keys.begin(), keys.end(), [&](const auto& key) { return same(key.pose); });
  if (kept) {
    editing_.perform(document::GoToTime{time_s_});
  } else {
    notices_.tell(std::string(k_not_keyed_yet));
  }
}

void Playback::advance(std::int64_t now_us) {
  if (!playing_) return;
  const auto& keys = editing_.document().timeline->keys;
  if (keys.empty() && last_s() <= 0) {
    playing_ = false;
    editing_.shown().preview(std::nullopt);
    return;
  }
  const double begin = loop_.begin_s();
  const double end = loop_.end_s(last_s());
  // What is heard may be behind when it begins.
  time_s_ = std::max(begin, played_s(now_us));
  if (end <= begin) {
    time_s_ = begin;
  } else if (time_s_ > end) {
    // Round and round, as an animator watches it.
    play_from_us_ = now_us;
    play_from_s_ = time_s_ = begin;
  }
  if (!keys.empty()) editing_.shown().preview(document::pose_at(editing_.document(), time_s_));
}

double Playback::last_s() const {
  const auto& keys = editing_.document().timeline->keys;
  const auto& camera = editing_.document().camera;
  return std::max({sound_end_s_, others_end_s_, keys.empty() ? 0.0 : keys.back().time_s,
                   camera ? camera->keys.back().time_s : 0.0});
}

void Playback::hear(double time_s, std::int64_t now_us) {
  if (!playing_) return;
  // Devices take samples in blocks: what is heard is followed smoothly.
  constexpr double k_share = 0.1;
  const double cursor_s = played_s(now_us);
  const double ahead_s = time_s - cursor_s;
  const bool far = std::abs(ahead_s) > 0.5 / rate_;
  play_from_s_ += far ? ahead_s : k_share * ahead_s;
}

}  // namespace penpose::app
