#include "core/io/fbx/write/fbx_keys.h"

#include <algorithm>
#include <cmath>

#include "core/io/fbx/fbx_scene.h"
#include "core/io/fbx/motion/fbx_curve.h"

namespace penpose::io {
namespace {

/// Its keys, and every frame in between where `dense` and there is room for them.
std::vector<double> moments_between(const document::Channel& channel, bool dense, FbxFrames& frames) {
  std::vector<double> times = channel.times_s;
  if (dense && times.size() > 1 && frames.a_second > 0.0) {
    const double count = (times.back() - times.front()) * frames.a_second;
    if (count <= frames.left) {
      frames.left -= count;
      const double last = times.back() * frames.a_second;
      for (double frame = std::floor(times.front() * frames.a_second) + 1.0; frame < last; ++frame)
        times.push_back(frame / frames.a_second);
      std::stable_sort(times.begin(), times.end());
    } else {
      frames.fewer = true;
    }
  }
  times.erase(std::unique(times.begin(), times.end(), [](double a, double b) { return b - a < 1e-6; }), times.end());
  return times;
}

/// The same rotation with angles as near as they can be to those before.
glm::dvec3 nearest(const glm::dvec3& angles, const glm::dvec3& before) {
  const glm::dvec3 other(angles.x + 180.0, 180.0 - angles.y, angles.z + 180.0);
  glm::dvec3 best(0);
  double least = 1e300;
  for (glm::dvec3 one : {angles, other}) {
    double off = 0;
    for (int i = 0; i < 3; ++i) {
      one[i] -= 360.0 * std::round((one[i] - before[i]) / 360.0);
      off += std::abs(one[i] - before[i]);
    }
    if (off >= least) continue;
    least = off;
    best = one;
  }
  return best;
}

glm::dmat3 rotation_of(const glm::dquat& q) { return glm::mat3_cast(q); }

}  // namespace

std::int64_t FbxKeys::ticks_of(double time_s) { return std::llround(time_s * k_fbx_ticks); }

FbxKeys::Local FbxKeys::at(const rig::Joint& joint, const glm::dvec3& turn) {
  // The parameters turn about x behind y behind z.
  constexpr double k_degrees = 180.0 / 3.14159265358979323846;
  const glm::dmat3 own = fbx_rotation(turn * k_degrees, 5);
  return {joint.translation, fbx_angles(rotation_of(joint.rest_rotation) * own, 0), joint.scale};
}

FbxKeys FbxKeys::of_weight(const document::Channel& channel, std::size_t width, std::size_t weight, FbxFrames& frames) {
  FbxKeys keys;
  keys.steps = channel.interpolation == document::Interpolation::step;
  for (const double time_s :
       moments_between(channel, channel.interpolation == document::Interpolation::cubic_spline, frames)) {
    const auto values = document::sample_channel(channel, width, time_s);
    if (weight >= values.size()) return {};
    keys.ticks.push_back(ticks_of(time_s));
    keys.values[0].push_back(values[weight] * 100.0);
  }
  return keys;
}

FbxKeys FbxKeys::of_joint(const document::Channel& channel, FbxFrames& frames) {
  FbxKeys keys;
  keys.steps = channel.interpolation == document::Interpolation::step;
  const bool turns = channel.target == document::ChannelTarget::rotation;
  const bool dense = !keys.steps && (turns || channel.interpolation == document::Interpolation::cubic_spline);
  glm::dvec3 before(0);
  for (const double time_s : moments_between(channel, dense, frames)) {
    const auto values = document::sample_channel(channel, turns ? 4 : 3, time_s);
    if (values.size() < 3) return {};
    glm::dvec3 now(values[0], values[1], values[2]);
    if (turns)
      now = nearest(fbx_angles(rotation_of(glm::dquat(values[3], values[0], values[1], values[2])), 0), before);
    before = now;
    keys.ticks.push_back(ticks_of(time_s));
    for (int axis = 0; axis < 3; ++axis) keys.values[static_cast<std::size_t>(axis)].push_back(now[axis]);
  }
  return keys;
}

}  // namespace penpose::io
