#include "core/intent/chain.h"

#include <algorithm>

#include "core/rig/character_rig.h"

namespace penpose::intent {
namespace {

constexpr std::size_t k_no_joint = static_cast<std::size_t>(-1);
/// A stroke along a limb begins or ends on what the limb hangs on with less than this share of its points.
constexpr double k_overlap = 0.15;

/// The joint with the greatest share in a point.
std::size_t carrier(const rig::Skeleton& skeleton, const posing::CurvePoint& point) {
  std::vector<double> share(skeleton.joints().size(), 0.0);
  for (std::size_t k = 0; k < 3; ++k) {
    for (const rig::Influence& influence : skeleton.influences_of(point.vertex[k]))
      share[influence.joint] += point.weight[k] * influence.weight;
  }
  const auto most = std::max_element(share.begin(), share.end());
  return most != share.end() && *most > 0.0 ? static_cast<std::size_t>(most - share.begin()) : k_no_joint;
}

}  // namespace

std::vector<std::size_t> chain_of(const rig::Rig& rig, std::span<const posing::CurvePoint> points,
                                  const joints::Body* body) {
  const auto* character = dynamic_cast<const rig::CharacterRig*>(&rig);
  if (character == nullptr || character->skeleton() == nullptr) return {};
  const rig::Skeleton& skeleton = *character->skeleton();
  const auto joints = skeleton.joints();
  std::vector<bool> carries(joints.size(), false);
  std::vector<std::size_t> carried(joints.size(), 0);
  std::size_t count = 0;
  for (const posing::CurvePoint& point : points) {
    std::size_t joint = carrier(skeleton, point);
    if (joint == k_no_joint) continue;
    if (body != nullptr) joint = body->meant(joint);
    ++carried[joint];
    if (carries[joint]) continue;
    carries[joint] = true;
    ++count;
  }
  // How many carriers lie at or below each joint: those between carriers have some below, but not yet all.
  std::vector<std::size_t> below(joints.size(), 0);
  for (std::size_t i = joints.size(); i-- > 0;) {
    below[i] += carries[i] ? 1U : 0U;
    if (joints[i].parent >= 0) below[static_cast<std::size_t>(joints[i].parent)] += below[i];
  }
  std::vector<std::size_t> chain;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (carries[i] || (below[i] > 0 && below[i] < count)) chain.push_back(i);
  }
  // The trunk that a stroke along a limb overlaps is not meant.
  if (body != nullptr && chain.size() > 1 && below[chain.front()] == count &&
      body->branches(chain.front()).size() > 1 &&
      static_cast<double>(carried[chain.front()]) < k_overlap * static_cast<double>(points.size()))
    chain.erase(chain.begin());
  return chain;
}

}  // namespace penpose::intent
