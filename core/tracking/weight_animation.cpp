#include "core/tracking/weight_animation.h"

#include <algorithm>
#include <cmath>

#include "core/animation/signal/denoise.h"
#include "core/base/math.h"
#include "core/base/numbers.h"
#include "core/base/text/closest_name.h"
#include "core/document/expressions.h"
#include "core/geometry/rotation.h"
#include "core/io/tracks/track_formats.h"
#include "core/io/tracks/vmd/shift_jis.h"
#include "core/rig/control_names.h"
#include "core/tracking/driven_controls.h"

namespace penpose::tracking {
namespace {

/// A control that a column drives.
struct Drive {
  DrivenControl to;
  double offset = 0;
  const std::vector<std::pair<double, double>>* response = nullptr;  ///< null: values as they are
};

/// A value by a response: straight between its points, level beyond them.
double responded(const std::vector<std::pair<double, double>>& points, double value) {
  const auto next = std::find_if(points.begin(), points.end(), [&](const auto& one) { return one.first >= value; });
  if (next == points.begin()) return points.front().second;
  if (next == points.end()) return points.back().second;
  const auto& [x0, y0] = *(next - 1);
  const auto& [x1, y1] = *next;
  return y0 + (y1 - y0) * (value - x0) / (x1 - x0);
}

const std::vector<io::MapTarget>* mapped(const io::MapFile& map, const std::string& name) {
  const auto found =
      std::find_if(map.names.begin(), map.names.end(), [&](const auto& pair) { return pair.first == name; });
  return found == map.names.end() ? nullptr : &found->second;
}

/// The control whose name begins with one that was cut off at the 15 bytes that a .vmd file has for it; nothing: it is
/// shorter, or several controls begin so.
std::optional<std::size_t> control_cut_off(const document::Model& model, const std::string& name) {
  constexpr std::size_t k_vmd_bytes = 15;
  if (io::shift_jis_of(name, k_vmd_bytes + 1).bytes.size() != k_vmd_bytes) return std::nullopt;
  const auto parameters = model.rig->parameters();
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (!parameters[i].name.starts_with(name)) continue;
    if (found) return std::nullopt;
    found = i;
  }
  return found;
}

double value_of(const Drive& drive, double value) {
  return drive.response == nullptr ? value : responded(*drive.response, value);
}

/// How much is shown of each expression's weight in a frame: binary ones and those that others override differ.
std::vector<double> shown_shares(const document::Model& model, const std::vector<std::vector<Drive>>& controls,
                                 const std::vector<double>& values) {
  std::vector<double> weights(model.expressions.size(), 0.0);
  for (std::size_t i = 0; i < controls.size(); ++i) {
    for (const Drive& one : controls[i]) {
      if (!one.to.expression) continue;
      double& weight = weights[*one.to.expression];
      weight = std::max(weight, one.to.share * value_of(one, values[i]));
    }
  }
  std::vector<double> shares = document::shown_weights(model, weights);
  for (std::size_t i = 0; i < shares.size(); ++i) shares[i] = weights[i] > 0 ? shares[i] / weights[i] : 1.0;
  return shares;
}

/// Holds the controls that a column drives, and a flag that its name is known even if it drives none.
struct Column {
  std::vector<Drive> drives;
  bool known = false;
};

Column column_named(const document::Model& model, const io::MapFile& map, const std::string& name) {
  Column column;
  if (const auto* targets = mapped(map, name)) {
    for (const io::MapTarget& target : *targets) {
      column.known = column.known || is_driven(model, target.control);
      for (DrivenControl one : driven_controls(model, target.control)) {
        one.gain *= target.gain;
        one.share *= target.gain;
        column.drives.push_back({one, target.offset, target.response.empty() ? nullptr : &target.response});
      }
    }
    return column;
  }
  for (const DrivenControl& one : driven_controls(model, name)) column.drives.push_back({one});
  column.known = is_driven(model, name);
  if (!column.known && map.format != nullptr && map.format->name == "vmd") {
    if (const auto cut = control_cut_off(model, name)) column.drives.push_back({{*cut, 1}});
  }
  return column;
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
  std::vector<std::vector<Drive>> controls;
  const std::vector<std::size_t> head{column_of(track, "headpitch"), column_of(track, "headyaw"),
                                      column_of(track, "headroll")};
  const bool turns = std::any_of(head.begin(), head.end(), [&](std::size_t c) { return c < track.names.size(); });
  std::vector<std::string> names;
  for (const rig::Parameter& parameter : model.rig->parameters()) names.push_back(parameter.name);
  for (std::size_t i = 0; i < track.names.size(); ++i) {
    Column column = column_named(model, map, track.names[i]);
    const bool is_head = std::find(head.begin(), head.end(), i) != head.end();
    if (column.drives.empty() && !(is_head && apply_head) && !column.known) {
      result.unmatched.push_back(track.names[i]);
      result.nearest.push_back(base::closest_name(track.names[i], names).value_or(""));
    }
    result.drives = result.drives || !column.drives.empty() || (is_head && apply_head);
    controls.push_back(std::move(column.drives));
  }
  const rig::Pose rest = rig::rest_pose(*model.rig);
  // What no column drives stays as it is, such as a shape of the body that the file has at some weight.
  rig::Pose pose = rest;
  std::copy_n(model.pose.begin(), document::weight_count(model), pose.begin());
  for (const std::vector<Drive>& of_column : controls) {
    for (const Drive& one : of_column) pose[one.to.parameter] = rest[one.to.parameter];
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
    const std::vector<double> shown = frame.found ? shown_shares(model, controls, frame.values) : std::vector<double>();
    for (std::size_t i = 0; frame.found && i < controls.size(); ++i) {
      for (const Drive& one : controls[i]) {
        const std::size_t c = one.to.parameter;
        const rig::Parameter& range = model.rig->parameters()[c];
        const double base = one.to.gain == 1 ? 0 : range.rest;
        const double value = value_of(one, frame.values[i]);
        const double wanted =
            base + one.offset + one.to.gain * value * (one.to.expression ? shown[*one.to.expression] : 1.0);
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
