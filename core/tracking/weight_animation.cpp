#include "core/tracking/weight_animation.h"

#include <algorithm>
#include <cmath>

#include "core/animation/signal/denoise.h"
#include "core/base/math.h"
#include "core/base/numbers.h"
#include "core/geometry/rotation.h"
#include "core/rig/control_names.h"
#include "core/tracking/driven_controls.h"

namespace penpose::tracking {
namespace {

std::string renamed(const io::MapFile& map, const std::string& name) {
  const auto other =
      std::find_if(map.names.begin(), map.names.end(), [&](const auto& pair) { return pair.first == name; });
  return other == map.names.end() ? name : other->second;
}

/// The column of that folded name, or past the end.
std::size_t column_of(const animation::WeightTrack& track, const char* folded) {
  const auto at = std::find_if(track.names.begin(), track.names.end(),
                               [&](const std::string& name) { return rig::folded_name(name) == folded; });
  return static_cast<std::size_t>(at - track.names.begin());
}

/// Values of a column that are cut: percent for shares show as a mouth that is always open.
struct Cut {
  std::size_t count = 0;
  std::size_t first_frame = 0;
  double first = 0;
  rig::Parameter range;
};

std::vector<std::string> notes_on(const std::vector<std::string>& names, const std::vector<Cut>& cuts) {
  constexpr std::size_t k_most = 5;
  std::vector<std::string> notes;
  std::size_t columns = 0;
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    if (cuts[i].count == 0 || ++columns > k_most) continue;
    notes.push_back("column " + names[i] + ": " + std::to_string(cuts[i].count) + " values are cut to " +
                    base::format_double(cuts[i].range.minimum) + ".." + base::format_double(cuts[i].range.maximum) +
                    ", the first in frame " + std::to_string(cuts[i].first_frame) + ": " +
                    base::format_double(cuts[i].first));
  }
  if (columns > k_most) notes.push_back("and values of " + std::to_string(columns - k_most) + " columns more are cut");
  return notes;
}

}  // namespace

WeightAnimation animate_weights(const document::Model& model, const animation::WeightTrack& track,
                                const io::MapFile& map, bool apply_head, double smooth_s) {
  WeightAnimation result;
  std::vector<std::vector<DrivenControl>> controls;
  const std::vector<std::size_t> head{column_of(track, "headpitch"), column_of(track, "headyaw"),
                                      column_of(track, "headroll")};
  const bool turns = std::any_of(head.begin(), head.end(), [&](std::size_t c) { return c < track.names.size(); });
  for (std::size_t i = 0; i < track.names.size(); ++i) {
    const std::string name = renamed(map, track.names[i]);
    controls.push_back(driven_controls(model, name));
    const bool is_head = std::find(head.begin(), head.end(), i) != head.end();
    if (controls.back().empty() && !(is_head && apply_head) && !is_driven(model, name)) {
      result.unmatched.push_back(track.names[i]);
    }
    result.drives = result.drives || !controls.back().empty() || (is_head && apply_head);
  }
  const rig::Pose rest = rig::rest_pose(*model.rig);
  // What no column drives stays as it is, such as a shape of the body that the file has at some weight.
  rig::Pose pose = rest;
  std::copy_n(model.pose.begin(), document::weight_count(model), pose.begin());
  for (const std::vector<DrivenControl>& of_column : controls) {
    for (const DrivenControl& one : of_column) pose[one.parameter] = rest[one.parameter];
  }
  std::vector<std::vector<double>> angles;
  std::vector<double> now(3, 0.0);
  std::vector<Cut> cuts(track.names.size());
  std::vector<double> driven(pose.size(), 0.0);  // 0: by no column yet, else 1 more than how far from rest
  for (std::size_t f = 0; f < track.frames.size(); ++f) {
    const animation::WeightFrame& frame = track.frames[f];
    result.times_s.push_back(frame.time_s);
    if (!frame.found) result.held.push_back(f);
    // Of several columns that drive a control the one that moves it farther counts.
    if (frame.found) std::fill(driven.begin(), driven.end(), 0.0);
    for (std::size_t i = 0; frame.found && i < controls.size(); ++i) {
      for (const DrivenControl& one : controls[i]) {
        const std::size_t c = one.parameter;
        const rig::Parameter& range = model.rig->parameters()[c];
        const double base = one.gain == 1 ? 0 : range.rest;
        const double wanted = base + one.gain * frame.values[i];
        const bool first = driven[c] == 0;
        if (!first && !(std::abs(wanted - range.rest) > driven[c] - 1)) continue;
        driven[c] = 1 + std::abs(wanted - range.rest);
        pose[c] = std::clamp(wanted, range.minimum, range.maximum);
        // Trackers overshoot a little.
        if (std::abs(wanted - pose[c]) <= 0.1 * (range.maximum - range.minimum)) continue;
        if (cuts[i].count++ == 0) cuts[i] = {1, f, frame.values[i], range};
      }
    }
    for (std::size_t k = 0; frame.found && k < 3; ++k) {
      if (head[k] < track.names.size()) now[k] = frame.values[head[k]];
    }
    result.poses.push_back(pose);
    angles.push_back(now);
  }
  result.notes = notes_on(track.names, cuts);
  animation::smooth_over_time(result.times_s, smooth_s, result.poses);
  if (!apply_head || !turns) return result;
  animation::smooth_over_time(result.times_s, smooth_s, angles);
  // The angles are about the axes of a face that looks along +z.
  const glm::dquat front = geometry::quaternion_from_xyz({0, base::radians(model.front_yaw_degrees), 0});
  for (const auto& a : angles) {
    const glm::dquat turn = geometry::quaternion_from_xyz({a[0], a[1], a[2]});
    const bool ahead = model.front_yaw_degrees == 0;
    result.placements.push_back({ahead ? turn : front * turn * glm::conjugate(front), geometry::ModelVector(0), 1});
  }
  return result;
}

}  // namespace penpose::tracking
