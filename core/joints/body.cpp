#include "core/joints/body.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/math.h"
#include "core/geometry/rotation.h"

namespace penpose::joints {
namespace {

/// A limb's middle joint that is bent by less shows no plane; one that is bent by more is a corner, not a hinge at
/// rest.
constexpr double k_least_bend = 4.0, k_most_bend = 50.0;
/// Longer ways without branches are tails, tentacles and ropes, whose bends at rest are curls.
constexpr std::size_t k_longest_limb = 5;
/// How far from its parent's bone a helper may lie, as a share of the bone's length.
constexpr double k_off_bone = 0.1;

/// Whether a point lies on the bone from a joint to another, short of its end.
bool on_bone(const ModelPoint& point, const ModelPoint& from, const ModelPoint& to) {
  const ModelVector bone = to - from;
  const double square = glm::dot(bone, bone);
  if (!(square > 0.0)) return false;
  const double along = glm::dot(point - from, bone) / square;
  if (along < -k_off_bone || along > 1.0 - k_off_bone) return false;
  return geometry::distance(point, from + bone * along) <= k_off_bone * std::sqrt(square);
}

}  // namespace

std::vector<Place> places_of(const rig::Skeleton& skeleton, std::span<const double> values) {
  const auto joints = skeleton.joints();
  std::vector<glm::dmat4> world(joints.size());
  std::vector<Place> places(joints.size());
  std::size_t next = 0;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    glm::dquat turn = joints[j].rest_rotation;
    const double norm = std::sqrt(glm::dot(turn, turn));
    turn = norm > 1e-300 ? turn / norm : glm::dquat(1, 0, 0, 0);
    if (joints[j].posable) {
      turn = turn * geometry::quaternion_from_xyz({values[next], values[next + 1], values[next + 2]});
      next += 3;
    }
    world[j] = geometry::compose(joints[j].translation, turn, joints[j].scale);
    places[j].turn = turn;
    if (joints[j].parent >= 0) {
      const auto parent = static_cast<std::size_t>(joints[j].parent);
      world[j] = world[parent] * world[j];
      places[j].turn = places[parent].turn * turn;
    }
    places[j].at = ModelPoint(world[j][3]);
  }
  return places;
}

Body::Body(const rig::Skeleton& skeleton) {
  const auto joints = skeleton.joints();
  const std::size_t n = joints.size();
  rest_ = places_of(skeleton, std::vector<double>(skeleton.parameters().size(), 0.0));
  children_.resize(n);
  branches_.resize(n);
  helper_.assign(n, false);
  std::vector<bool> carries(n, false);
  for (std::uint32_t v = 0; v < skeleton.vertex_count(); ++v) {
    for (const rig::Influence& influence : skeleton.influences_of(v))
      if (influence.weight > 0.0) carries[influence.joint] = true;
  }
  for (std::size_t j = n; j-- > 0;) {
    if (carries[j] && joints[j].parent >= 0) carries[static_cast<std::size_t>(joints[j].parent)] = true;
  }
  for (std::size_t j = 0; j < n; ++j) {
    parents_.push_back(joints[j].parent);
    if (joints[j].parent < 0) continue;
    children_[static_cast<std::size_t>(joints[j].parent)].push_back(j);
    if (carries[j]) branches_[static_cast<std::size_t>(joints[j].parent)].push_back(j);
  }
  for (std::size_t j = 0; j < n; ++j) {
    const auto& siblings = branches_[j];
    for (const std::size_t one : siblings) {
      helper_[one] = branches_[one].empty() && std::any_of(siblings.begin(), siblings.end(), [&](std::size_t other) {
                       return other != one && on_bone(rest_[one].at, rest_[j].at, rest_[other].at);
                     });
    }
  }
  for (auto& branches : branches_) std::erase_if(branches, [&](std::size_t one) { return helper_[one]; });
}

std::size_t Body::meant(std::size_t joint) const {
  return helper_[joint] ? static_cast<std::size_t>(parents_[joint]) : joint;
}

ModelVector Body::bone(std::size_t joint, std::span<const std::size_t> chain) const {
  const auto& branches = branches_[joint].empty() ? children_[joint] : branches_[joint];
  ModelVector sum{0};
  for (const std::size_t one : branches) {
    const ModelVector way = rest_[one].at - rest_[joint].at;
    if (std::binary_search(chain.begin(), chain.end(), one) && geometry::length(way) > 0.0)
      return geometry::normalized(way);
    sum += way;
  }
  if (!(geometry::length(sum) > 0.0) && parents_[joint] >= 0)
    sum = rest_[joint].at - rest_[static_cast<std::size_t>(parents_[joint])].at;
  return geometry::length(sum) > 0.0 ? geometry::normalized(sum) : ModelVector{0, 1, 0};
}

double Body::reach(std::size_t joint) const {
  double longest = 0;
  for (const std::size_t one : branches_[joint])
    longest = std::max(longest, geometry::distance(rest_[joint].at, rest_[one].at) + reach(one));
  return longest;
}

bool Body::on_limb(std::size_t joint) const {
  std::size_t first = joint;
  while (parents_[first] >= 0 && branches_[static_cast<std::size_t>(parents_[first])].size() == 1)
    first = static_cast<std::size_t>(parents_[first]);
  std::size_t end = first;
  std::size_t count = 1;
  double length = 0;
  for (; branches_[end].size() == 1; ++count) {
    const std::size_t next = branches_[end].front();
    length += geometry::distance(rest_[end].at, rest_[next].at);
    end = next;
  }
  return count <= k_longest_limb && reach(end) <= length;
}

std::optional<Hinge> Body::hinge(std::size_t joint) const {
  if (parents_[joint] < 0 || branches_[joint].size() != 1 || !on_limb(joint)) return std::nullopt;
  const auto parent = static_cast<std::size_t>(parents_[joint]);
  if (branches_[parent].size() != 1) return std::nullopt;
  const ModelVector before = rest_[joint].at - rest_[parent].at;
  const ModelVector after = rest_[branches_[joint].front()].at - rest_[joint].at;
  if (!(geometry::length(before) > 0.0) || !(geometry::length(after) > 0.0)) return std::nullopt;
  const geometry::Turn turn = geometry::turn_between(before, after);
  if (turn.angle < base::radians(k_least_bend) || turn.angle > base::radians(k_most_bend)) return std::nullopt;
  return Hinge{turn.axis, turn.angle};
}

}  // namespace penpose::joints
