#include "core/prior/leave_one_out.h"

#include <algorithm>
#include <cmath>

namespace penpose::prior {
namespace {

rig::Pose at_rest(std::span<const rig::Parameter> parameters) {
  rig::Pose pose;
  for (const rig::Parameter& parameter : parameters) pose.push_back(parameter.rest);
  return pose;
}

/// The rest pose with what is held as in a key.
rig::Pose begun(const rig::Pose& rest, const rig::Pose& key, std::span<const std::size_t> held) {
  rig::Pose pose = rest;
  for (const std::size_t i : held) pose[i] = key[i];
  return pose;
}

std::vector<rig::Pose> without(std::span<const rig::Pose> keys, std::size_t left_out) {
  std::vector<rig::Pose> others(keys.begin(), keys.end());
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(left_out));
  return others;
}

std::vector<rig::Pose> distinct_poses(std::span<const rig::Pose> keys) {
  std::vector<rig::Pose> out;
  for (const std::size_t k : distinct(keys)) out.push_back(keys[k]);
  return out;
}

/// The held parameters at their values and the others that the keys vary at their mean.
rig::Pose at_mean(std::span<const rig::Pose> keys, rig::Pose pose, std::span<const std::size_t> held) {
  for (std::size_t i = 0; i < pose.size(); ++i) {
    if (std::binary_search(held.begin(), held.end(), i)) continue;
    double sum = 0;
    for (const rig::Pose& key : keys) sum += key[i];
    pose[i] = sum / static_cast<double>(keys.size());
  }
  return pose;
}

double way_between(const std::vector<rig::ModelPoint>& a, const std::vector<rig::ModelPoint>& b) {
  double sum = 0;
  for (std::size_t v = 0; v < a.size(); ++v) {
    const rig::ModelVector way = a[v] - b[v];
    sum += way.x * way.x + way.y * way.y + way.z * way.z;
  }
  return std::sqrt(sum);
}

}  // namespace

double trust(const rig::Rig& rig, std::span<const rig::Pose> keys, const HeldOf& held) {
  const auto parameters = rig.parameters();
  std::vector<rig::Pose> poses = distinct_poses(keys);
  if (poses.size() > k_most_left_out) {
    std::vector<rig::Pose> some;
    for (std::size_t k = 0; k < k_most_left_out; ++k) some.push_back(poses[k * poses.size() / k_most_left_out]);
    poses = std::move(some);
  }
  if (poses.size() < 3) return 1;
  // In the order of their values, so that moving keys in time changes no bit.
  std::stable_sort(poses.begin(), poses.end());
  const rig::Pose rest = at_rest(parameters);
  double right = 0;
  double all = 0;
  std::vector<rig::ModelPoint> truth(rig.vertex_count());
  std::vector<rig::ModelPoint> from(rig.vertex_count());
  std::vector<rig::ModelPoint> to(rig.vertex_count());
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const std::vector<std::size_t> known = held(poses[k]);
    const rig::Pose start = begun(rest, poses[k], known);
    const auto prior = learn(parameters, without(poses, k));
    if (!prior) continue;
    const auto pose = suggest(*prior, parameters, start, known);
    if (!pose || *pose == start) continue;
    rig.evaluate(poses[k], truth);
    rig.evaluate(start, from);
    rig.evaluate(*pose, to);
    for (std::size_t v = 0; v < truth.size(); ++v) {
      const rig::ModelVector moved = to[v] - from[v];
      const rig::ModelVector wanted = truth[v] - from[v];
      right += moved.x * wanted.x + moved.y * wanted.y + moved.z * wanted.z;
      all += moved.x * moved.x + moved.y * moved.y + moved.z * moved.z;
    }
  }
  return all > 0 ? std::clamp(right / all, 0.0, 1.0) : 1;
}

base::Result<std::vector<LeftOut>> leave_one_out(const rig::Rig& rig, std::span<const rig::Pose> keys,
                                                 const HeldOf& held, std::optional<double> strength,
                                                 const std::function<void()>& done) {
  const auto parameters = rig.parameters();
  if (const auto all = learn(parameters, keys); !all) return all.error();
  const std::vector<std::size_t> used = distinct(keys);
  if (used.size() < 3) {
    return base::Error{"one of two poses cannot be left out: what is left is one", "", "key three different poses"};
  }
  const std::vector<rig::Pose> poses = distinct_poses(keys);
  const rig::Pose rest = at_rest(parameters);
  const auto positions = [&](const rig::Pose& pose) {
    std::vector<rig::ModelPoint> out(rig.vertex_count());
    rig.evaluate(pose, out);
    return out;
  };
  const auto rest_positions = positions(rest);
  std::vector<LeftOut> rows;
  for (std::size_t k = 0; k < used.size(); ++k) {
    const std::vector<std::size_t> known = held(poses[k]);
    if (!known.empty()) {
      const std::vector<rig::Pose> others = without(poses, k);
      const rig::Pose start = begun(rest, poses[k], known);
      LeftOut row{used[k], 0, 0, 0, 0, 0, known.size()};
      const auto truth = positions(poses[k]);
      row.way = way_between(truth, rest_positions);
      row.still = way_between(truth, positions(start));
      row.mean = way_between(truth, positions(at_mean(others, start, known)));
      row.suggested = row.still;
      if (const auto prior = learn(parameters, others)) {
        row.strength = strength ? *strength : trust(rig, others, held);
        if (const auto pose = suggest(*prior, parameters, start, known, row.strength)) {
          row.suggested = way_between(truth, positions(*pose));
        }
      }
      rows.push_back(row);
    }
    if (done) done();
  }
  return rows;
}

}  // namespace penpose::prior
