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
      last_(still_) {
  frames_[static_cast<int>(at_)] = still_;
}

void Performance::note_moved(const rig::Pose& pose) {
  for (std::size_t i = 0; i < moved_.size(); ++i) moved_[i] = moved_[i] || pose[i] != still_[i];
}

void Performance::take(double time_s, const rig::Pose& pen) {
  if (pen.size() != still_.size()) return;
  note_moved(pen);
  const double at = frame_of(time_s, rate_);
  if (at < at_) {
    // Another round.
    frames_[static_cast<int>(std::ceil(at))] = pen;
  } else {
    for (int frame = static_cast<int>(std::floor(at_)) + 1; frame <= at; ++frame) {
      const double u = (frame - at_) / (at - at_);
      rig::Pose& pose = frames_[frame] = last_;
      for (std::size_t i = 0; i < pose.size(); ++i) pose[i] += (pen[i] - pose[i]) * u;
    }
  }
  at_ = at;
  last_ = pen;
}

rig::Pose Performance::over(rig::Pose background, const rig::Pose& pen) const {
  for (std::size_t i = 0; i < moved_.size() && i < background.size() && i < pen.size(); ++i) {
    if (moved_[i]) background[i] = pen[i];
  }
  return background;
}

double Performance::last_s() const { return time_of_frame(frames_.rbegin()->first, rate_); }

std::optional<document::KeyPoses> Performance::keys(std::span<const rig::Parameter> parameters,
                                                    const rig::Pose& now) const {
  document::KeyPoses keys;
  std::vector<std::size_t> numbers;
  if (parameters.size() != still_.size() || now.size() != still_.size()) return std::nullopt;  // another rig by now
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (!moved_[i] && now[i] == still_[i]) continue;
    numbers.push_back(i);
    keys.names.push_back(parameters[i].name);
  }
  if (numbers.empty()) return std::nullopt;
  for (const auto& [frame, pose] : frames_) {
    keys.times_s.push_back(time_of_frame(frame, rate_));
    for (const std::size_t i : numbers)
      keys.values.push_back(std::clamp(pose[i], parameters[i].minimum, parameters[i].maximum));
  }
  return keys;
}

}  // namespace penpose::app
