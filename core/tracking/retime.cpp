#include "core/tracking/retime.h"

#include <algorithm>
#include <cmath>

#include "core/base/math.h"
#include "core/rig/control_names.h"
#include "core/rig/names/face_names.h"

namespace penpose::tracking {
namespace {

template <typename Track>
void put_evenly(Track& track, double fps) {
  for (std::size_t f = 0; f < track.frames.size(); ++f) track.frames[f].time_s = static_cast<double>(f) / fps;
  track.rate_note.clear();
}

bool was_found(const animation::WeightFrame& frame) { return frame.found; }
bool was_found(const animation::TrackFrame& frame) { return frame.found(); }

double between(double a, double b, double share) { return a + share * (b - a); }

void go_between(animation::WeightFrame& frame, const animation::WeightFrame& a, const animation::WeightFrame& b,
                double share) {
  for (std::size_t i = 0; i < frame.values.size(); ++i) frame.values[i] = between(a.values[i], b.values[i], share);
}

void go_between(animation::TrackFrame& frame, const animation::TrackFrame& a, const animation::TrackFrame& b,
                double share) {
  frame.confidence = std::min(a.confidence, b.confidence);
  for (std::size_t i = 0; i < frame.points.size(); ++i)
    frame.points[i] = a.points[i] + (b.points[i] - a.points[i]) * share;
  if (a.depths.size() != b.depths.size()) return;
  for (std::size_t i = 0; i < frame.depths.size(); ++i) frame.depths[i] = between(a.depths[i], b.depths[i], share);
}

template <typename Track>
base::Status resampled(Track& track, double fps) {
  constexpr double k_most_frames = 1e6;
  constexpr double k_on_time = 1e-9;
  if (track.frames.empty()) return base::Done{};
  const double first_s = track.frames.front().time_s;
  const double length = std::floor((track.frames.back().time_s - first_s) * fps + 1e-6);
  if (!(length < k_most_frames)) return base::Error{"that makes over a million frames", "fps", "choose a lower rate"};
  const auto count = static_cast<std::size_t>(length) + 1;
  decltype(track.frames) frames;
  std::size_t at = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double time_s = first_s + static_cast<double>(k) / fps;
    while (at + 1 < track.frames.size() && track.frames[at + 1].time_s <= time_s + k_on_time) ++at;
    const auto& a = track.frames[at];
    const auto& b = track.frames[std::min(at + 1, track.frames.size() - 1)];
    const double apart = b.time_s - a.time_s;
    const double share = apart > 0 ? std::clamp((time_s - a.time_s) / apart, 0.0, 1.0) : 0.0;
    frames.push_back(share > 0.5 ? b : a);
    if (was_found(a) && was_found(b) && share > 0) go_between(frames.back(), a, b, share);
    frames.back().time_s = time_s;
  }
  track.frames = std::move(frames);
  return base::Done{};
}

}  // namespace

void stretch(animation::WeightTrack& track, double fps) { put_evenly(track, fps); }
void stretch(animation::PointTrack& track, double fps) { put_evenly(track, fps); }
base::Status resample(animation::WeightTrack& track, double fps) { return resampled(track, fps); }
base::Status resample(animation::PointTrack& track, double fps) { return resampled(track, fps); }

base::Status subtract_neutral(animation::WeightTrack& track, std::size_t frame) {
  if (frame >= track.frames.size()) {
    return base::Error{
        "there is no frame " + std::to_string(frame) + "; the track has " + std::to_string(track.frames.size()),
        "neutral", "frames count from 0"};
  }
  if (!track.frames[frame].found)
    return base::Error{"frame " + std::to_string(frame) + " shows no face", "neutral", "name one that does"};
  const std::vector<double> rest = track.frames[frame].values;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    bool is_share = true;
    for (const auto& one : track.frames) is_share = is_share && (!one.found || one.values[i] >= 0);
    for (auto& one : track.frames) {
      if (!one.found) continue;
      one.values[i] = is_share ? std::max(0.0, one.values[i] - rest[i]) : one.values[i] - rest[i];
    }
  }
  return base::Done{};
}

bool divide_percent(animation::WeightTrack& track) {
  constexpr double k_beyond_share = 2;
  constexpr double k_most = 100.5;
  std::vector<double> most(track.names.size(), 0.0);
  for (const auto& frame : track.frames) {
    for (std::size_t i = 0; i < frame.values.size(); ++i) most[i] = std::max(most[i], std::abs(frame.values[i]));
  }
  std::size_t moving = 0, far = 0;
  for (std::size_t i = 0; i < most.size(); ++i) {
    if (!rig::face_name(track.names[i]) || most[i] == 0) continue;
    if (most[i] > k_most) return false;
    ++moving;
    if (most[i] > k_beyond_share) ++far;
  }
  if (2 * far <= moving || moving == 0) return false;
  for (auto& frame : track.frames) {
    for (std::size_t i = 0; i < frame.values.size(); ++i) {
      if (rig::face_name(track.names[i])) frame.values[i] /= 100;
    }
  }
  return true;
}

bool take_degrees(animation::WeightTrack& track) {
  constexpr double k_half_turn = 3.2;
  constexpr double k_fast = 8;  // radians a second, of a head
  std::vector<std::size_t> turns;
  for (std::size_t i = 0; i < track.names.size(); ++i) {
    const std::string name = rig::folded_name(track.names[i]);
    const bool part = name.starts_with("head") || name.starts_with("lefteye") || name.starts_with("righteye");
    if (part && (name.ends_with("yaw") || name.ends_with("pitch") || name.ends_with("roll"))) turns.push_back(i);
  }
  bool beyond = false, whole = true;
  double most = 0;
  std::size_t steps = 0, fast = 0;
  for (const std::size_t i : turns) {
    const bool head = rig::folded_name(track.names[i]).starts_with("head");
    const animation::WeightFrame* before = nullptr;
    for (const auto& frame : track.frames) {
      if (!frame.found) continue;
      const double value = frame.values[i];
      beyond = beyond || std::abs(value) > k_half_turn;
      whole = whole && value == std::floor(value);
      most = std::max(most, std::abs(value));
      const double step = head && before != nullptr ? std::abs(value - before->values[i]) : 0;
      if (step > 0) ++steps;
      if (step > 0 && step > k_fast * (frame.time_s - before->time_s)) ++fast;
      before = &frame;
    }
  }
  const bool degrees = beyond || (whole && most >= 2) || (steps >= 10 && 10 * fast > steps);
  if (!degrees) return false;
  for (auto& frame : track.frames) {
    for (const std::size_t i : turns) {
      if (frame.found) frame.values[i] = base::radians(frame.values[i]);
    }
  }
  return true;
}

}  // namespace penpose::tracking
