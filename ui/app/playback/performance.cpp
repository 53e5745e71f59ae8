#include "ui/app/playback/performance.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/app/playback/frames.h"

namespace penpose::app {

Performance::Performance(double time_s, int rate, rig::Pose still)
    : rate_(rate),
      still_(std::move(still)),
      moved_(still_.size(), false),
      at_(std::round(frame_of(time_s, rate))),
      last_{still_, 0} {
  frames_[static_cast<int>(at_)] = last_;
}

void Performance::note_moved(const rig::Pose& pose) {
  for (std::size_t i = 0; i < moved_.size(); ++i) moved_[i] = moved_[i] || pose[i] != still_[i];
}

void Performance::take(double time_s, const rig::Pose& pen, double drawn_px) {
  if (pen.size() != still_.size()) return;
  note_moved(pen);
  const double at = frame_of(time_s, rate_);
  if (at < at_) {
    // Another round.
    frames_[static_cast<int>(std::ceil(at))] = {pen, drawn_px};
  } else {
    for (int number = static_cast<int>(std::floor(at_)) + 1; number <= at; ++number) {
      const double u = (number - at_) / (at - at_);
      Frame& frame = frames_[number] = last_;
      frame.drawn_px += (drawn_px - frame.drawn_px) * u;
      for (std::size_t i = 0; i < pen.size(); ++i) frame.pose[i] += (pen[i] - frame.pose[i]) * u;
    }
  }
  at_ = at;
  last_ = {pen, drawn_px};
}

rig::Pose Performance::over(rig::Pose background, const rig::Pose& pen) const {
  for (std::size_t i = 0; i < moved_.size() && i < background.size() && i < pen.size(); ++i) {
    if (moved_[i]) background[i] = pen[i];
  }
  return background;
}

double Performance::first_s() const { return time_of_frame(frames_.begin()->first, rate_); }

double Performance::last_s() const { return time_of_frame(frames_.rbegin()->first, rate_); }

template <class Value>
std::optional<document::KeyPoses> Performance::keys_with(std::span<const rig::Parameter> parameters,
                                                         const std::vector<std::size_t>& numbers, Value value) const {
  if (numbers.empty()) return std::nullopt;
  document::KeyPoses keys;
  for (const std::size_t i : numbers) keys.names.push_back(parameters[i].name);
  for (const auto& [number, frame] : frames_) {
    keys.times_s.push_back(time_of_frame(number, rate_));
    for (const std::size_t i : numbers)
      keys.values.push_back(std::clamp(value(frame, i), parameters[i].minimum, parameters[i].maximum));
  }
  return keys;
}

std::optional<document::KeyPoses> Performance::keys(std::span<const rig::Parameter> parameters,
                                                    const rig::Pose& now) const {
  std::vector<std::size_t> numbers;
  if (parameters.size() != still_.size() || now.size() != still_.size()) return std::nullopt;  // another rig by now
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (moved_[i] || now[i] != still_[i]) numbers.push_back(i);
  }
  return keys_with(parameters, numbers, [](const Frame& frame, std::size_t i) { return frame.pose[i]; });
}

std::optional<document::KeyPoses> Performance::keys_of_line(std::span<const rig::Parameter> parameters,
                                                            const rig::Pose& now) const {
  std::vector<std::size_t> numbers;
  if (parameters.size() != still_.size() || now.size() != still_.size()) return std::nullopt;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (now[i] != still_[i]) numbers.push_back(i);
  }
  // A loop ends where it ends: what was drawn in its last round is all of the line.
  double all = 0;
  for (const auto& [number, frame] : frames_) all = std::max(all, frame.drawn_px);
  const auto last = frames_.rbegin();
  return keys_with(parameters, numbers, [&](const Frame& frame, std::size_t i) {
    if (&frame == &last->second || frame.drawn_px >= all) return now[i];
    return still_[i] + (now[i] - still_[i]) * (frame.drawn_px / all);
  });
}

}  // namespace penpose::app
