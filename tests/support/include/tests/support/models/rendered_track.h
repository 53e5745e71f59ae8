#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "core/animation/track.h"
#include "core/document/model.h"
#include "core/geometry/camera.h"

namespace penpose::tests {

/// Pseudo-random numbers in -1..1, the same every time.
class Shaker {
 public:
  explicit Shaker(std::uint64_t seed = 1) : state_(seed) {}
  double operator()() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state_ >> 11U) / 4503599627370496.0 - 1.0;
  }

 private:
  std::uint64_t state_;
};

/// The poses of a clip: what a face does while it talks, blinks and frowns. Parameters that the model lacks are left
/// out.
inline std::vector<rig::Pose> talking_clip(const rig::Rig& rig, std::size_t frames) {
  std::vector<rig::Pose> poses;
  for (std::size_t f = 0; f < frames; ++f) {
    rig::Pose pose = rig::rest_pose(rig);
    const double t = static_cast<double>(f) / 30.0;
    const auto set = [&](const char* name, double value) {
      if (const auto p = rig::find_parameter(rig.parameters(), name)) pose[*p] = std::clamp(value, 0.0, 1.0);
    };
    // Starts at rest.
    const double in = std::min(1.0, t);
    const double blink = std::max(0.0, 1.0 - std::abs(std::fmod(t + 1.0, 2.5) - 2.0) / 0.12);
    set("jawOpen", in * (0.25 - 0.25 * std::cos(7.0 * t)));
    set("mouthSmile_L", in * (0.4 * std::sin(1.3 * t)));
    set("mouthSmile_R", in * (0.4 * std::sin(1.3 * t + 0.3)));
    set("mouthPucker", in * (0.5 * std::sin(2.1 * t - 2.0)));
    set("mouthFrown_L", in * (0.4 * std::sin(0.9 * t + 3.5)));
    set("mouthFrown_R", in * (0.4 * std::sin(0.9 * t + 3.5)));
    set("eyeBlink_L", blink);
    set("eyeBlink_R", blink);
    set("browInnerUp_L", in * (0.6 * std::sin(1.1 * t)));
    set("browInnerUp_R", in * (0.6 * std::sin(1.1 * t)));
    set("browOuterUp_L", in * (0.5 * std::sin(0.8 * t + 1.0)));
    set("browDown_L", in * (0.6 * std::sin(1.1 * t + 3.4)));
    set("browDown_R", in * (0.6 * std::sin(1.1 * t + 3.4)));
    poses.push_back(std::move(pose));
  }
  return poses;
}

/// What a perfect tracker of chosen vertices would see of a clip, with tremor in px added to each coordinate, and every
/// point sent through `move` (a head that moves).
inline animation::PointTrack track_of(
    const rig::Rig& rig, const std::vector<rig::Pose>& poses, const std::vector<std::uint32_t>& vertices,
    const geometry::Camera& camera, double tremor_px = 0,
    const std::function<geometry::ModelPoint(std::size_t, geometry::ModelPoint)>& move =
        [](std::size_t, geometry::ModelPoint p) { return p; }) {
  animation::PointTrack track;
  track.point_count = vertices.size();
  const auto bound = rig.bind(vertices);
  std::vector<geometry::ModelPoint> positions(vertices.size());
  Shaker shake;
  for (std::size_t f = 0; f < poses.size(); ++f) {
    bound->evaluate(poses[f], positions);
    animation::TrackFrame frame;
    frame.time_s = static_cast<double>(f) / 30.0;
    frame.confidence = 1;
    for (const auto& p : positions) {
      const auto px = camera.project(move(f, p)).value();
      const double dx = tremor_px * shake();
      const double dy = tremor_px * shake();
      frame.points.push_back({px.x + dx, px.y + dy});
    }
    track.frames.push_back(std::move(frame));
  }
  return track;
}

}  // namespace penpose::tests
