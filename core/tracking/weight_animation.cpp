#include "core/tracking/weight_animation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "core/animation/signal/denoise.h"
#include "core/base/numbers.h"
#include "core/document/expressions.h"
#include "core/geometry/rotation.h"
#include "core/rig/control_names.h"

namespace penpose::tracking {
namespace {

/// What a column drives: controls of its name, or where there are none, an expression.
struct Driven {
  std::vector<std::size_t> controls;
  std::optional<std::size_t> expression;
};

Driven driven_by(const document::Model& model, const io::MapFile& map, const std::string& column) {
  const auto renamed =
      std::find_if(map.names.begin(), map.names.end(), [&](const auto& pair) { return pair.first == column; });
  const std::string& name = renamed == map.names.end() ? column : renamed->second;
  Driven driven{rig::controls_named(model.rig->parameters(), name), std::nullopt};
  if (driven.controls.empty()) driven.expression = document::expression_named(model, name);
  return driven;
}

/// Adds what expressions do to the targets that they share (VRMC_vrm, expressions: the weights of several are summed),
/// within the targets' ranges.
class ExpressionSum {
 public:
  explicit ExpressionSum(const document::Model& model) : model_(model) {}

  void add(std::size_t expression, double weight) {
    for (const auto& [parameter, value] : model_.expressions[expression].values)
      sums_[parameter] += std::clamp(weight, 0.0, 1.0) * value;
  }
  void put(rig::Pose& pose) {
    for (auto& [parameter, sum] : sums_) {
      const rig::Parameter& range = model_.rig->parameters()[parameter];
      pose[parameter] = std::clamp(sum, range.minimum, range.maximum);
      sum = 0;
    }
  }

 private:
  const document::Model& model_;
  std::map<std::size_t, double> sums_;
};

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
  std::vector<Driven> driven;
  const std::vector<std::size_t> head{column_of(track, "headpitch"), column_of(track, "headyaw"),
                                      column_of(track, "headroll")};
  const bool turns = std::any_of(head.begin(), head.end(), [&](std::size_t c) { return c < track.names.size(); });
  for (std::size_t i = 0; i < track.names.size(); ++i) {
    driven.push_back(driven_by(model, map, track.names[i]));
    const bool is_head = std::find(head.begin(), head.end(), i) != head.end();
    const bool drives = !driven.back().controls.empty() || driven.back().expression;
    if (!drives && !(is_head && apply_head)) result.unmatched.push_back(track.names[i]);
  }
  rig::Pose pose = rig::rest_pose(*model.rig);
  std::vector<std::vector<double>> angles;
  std::vector<double> now(3, 0.0);
  std::vector<Cut> cuts(track.names.size());
  ExpressionSum expressions(model);
  for (std::size_t f = 0; f < track.frames.size(); ++f) {
    const animation::WeightFrame& frame = track.frames[f];
    result.times_s.push_back(frame.time_s);
    if (!frame.found) result.held.push_back(f);
    for (std::size_t i = 0; frame.found && i < driven.size(); ++i) {
      if (driven[i].expression) expressions.add(*driven[i].expression, frame.values[i]);
    }
    if (frame.found) expressions.put(pose);
    for (std::size_t i = 0; frame.found && i < driven.size(); ++i) {
      for (const std::size_t c : driven[i].controls) {
        const rig::Parameter& range = model.rig->parameters()[c];
        pose[c] = std::clamp(frame.values[i], range.minimum, range.maximum);
        // Trackers overshoot a little.
        if (std::abs(frame.values[i] - pose[c]) <= 0.1 * (range.maximum - range.minimum)) continue;
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
  for (const auto& a : angles) {
    result.placements.push_back({geometry::quaternion_from_xyz({a[0], a[1], a[2]}), geometry::ModelVector(0), 1});
  }
  return result;
}

}  // namespace penpose::tracking
