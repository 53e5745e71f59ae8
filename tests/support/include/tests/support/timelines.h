#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "core/document/time/timeline.h"

// Timelines to try things on.

namespace penpose::tests {

using document::ControlKey;
using document::KeyKind;
using document::PoseKey;
using document::Timeline;

/// One control's keys, smooth.
inline Timeline timeline_of(const std::vector<double>& times, const std::vector<double>& values) {
  Timeline timeline;
  for (std::size_t i = 0; i < times.size(); ++i) timeline.keys.push_back({times[i], rig::Pose{values[i]}, ""});
  return timeline;
}

/// The pose at a time where every control has a key.
inline rig::Pose sampled(const Timeline& timeline, double time_s) {
  return document::sample(timeline, time_s, rig::Pose(timeline.keys.front().pose.size(), 0.0));
}

inline constexpr std::array k_kinds{KeyKind::smooth,   KeyKind::linear, KeyKind::stepped, KeyKind::ease_in,
                                    KeyKind::ease_out, KeyKind::ease,   KeyKind::free,    KeyKind::overshoot};

/// All keys of all controls in one kind.
inline Timeline with_kind(Timeline timeline, KeyKind kind, double slope = 0) {
  for (PoseKey& key : timeline.keys)
    key.controls = std::vector<ControlKey>(key.pose.size(), ControlKey{kind, slope, slope});
  return timeline;
}

/// Keys of all parameters of the sheet at uneven moments.
inline Timeline random_timeline(const document::Model& model, std::size_t keys, std::uint64_t seed,
                                double least_s = 0.01) {
  std::mt19937_64 numbers(seed);
  const auto real = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(numbers() >> 11) * 0x1p-53;
  };
  Timeline timeline;
  double time = 0;
  for (std::size_t k = 0; k < keys; ++k) {
    PoseKey key;
    key.time_s = time += real(least_s, 2);
    rig::Pose pose;
    for (const rig::Parameter& p : model.rig->parameters()) {
      const double at = real(-0.5, 1.5);  // often at an end of the range
      pose.push_back(std::clamp(p.minimum + (p.maximum - p.minimum) * at, p.minimum, p.maximum));
    }
    key.pose = std::move(pose);
    timeline.keys.push_back(key);
  }
  return timeline;
}

}  // namespace penpose::tests
