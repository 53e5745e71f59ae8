#include "core/rig/joint_followers.h"

#include <algorithm>
#include <bit>

namespace penpose::rig {
namespace {

/// One a joint: whether it or a joint below it has a share in any vertex. Shares of zero count: times a number that is
/// not finite, they are none.
std::vector<bool> carrying_joints(const Skeleton& skeleton) {
  const auto joints = skeleton.joints();
  std::vector<bool> carry(joints.size(), false);
  for (std::uint32_t v = 0; v < skeleton.vertex_count(); ++v) {
    for (const Influence& influence : skeleton.influences_of(v)) carry[influence.joint] = true;
  }
  for (std::size_t i = joints.size(); i-- > 0;) {
    if (carry[i] && joints[i].parent >= 0) carry[static_cast<std::size_t>(joints[i].parent)] = true;
  }
  return carry;
}

}  // namespace

JointFollowers::JointFollowers(const CharacterRig& rig)
    : rig_(rig),
      skeleton_(*rig.skeleton()),
      values_(skeleton_.parameters().size(), 0.0),
      displaced_(rig.vertex_count()),
      posed_(skeleton_, carrying_joints(skeleton_)),
      marked_((rig.vertex_count() + 63) / 64, 0) {
  rig.displace(rest_pose(rig), displaced_);
  order_joints();
  list_influenced();
  find_drivers();
  posed_.turn(values_);
}

void JointFollowers::order_joints() {
  const auto joints = skeleton_.joints();
  const std::vector<bool> carry = carrying_joints(skeleton_);
  below_.assign(joints.size(), 0);
  for (std::size_t i = joints.size(); i-- > 0;) {
    if (!carry[i]) continue;
    ++below_[i];
    if (joints[i].parent >= 0) below_[static_cast<std::size_t>(joints[i].parent)] += below_[i];
  }
  position_.assign(joints.size(), 0);
  std::vector<std::uint32_t> next(joints.size(), 0);  // where the next child of each goes
  std::uint32_t next_root = 0;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (!carry[i]) continue;
    std::uint32_t& free = joints[i].parent >= 0 ? next[static_cast<std::size_t>(joints[i].parent)] : next_root;
    position_[i] = free;
    next[i] = free + 1;
    free += below_[i];
  }
  order_.resize(next_root);
  for (std::uint32_t i = 0; i < joints.size(); ++i) {
    if (carry[i]) order_[position_[i]] = i;
  }
}

void JointFollowers::list_influenced() {
  first_influenced_.assign(order_.size() + 1, 0);
  for (std::uint32_t v = 0; v < skeleton_.vertex_count(); ++v) {
    for (const Influence& influence : skeleton_.influences_of(v)) ++first_influenced_[position_[influence.joint] + 1];
  }
  for (std::size_t i = 0; i < order_.size(); ++i) first_influenced_[i + 1] += first_influenced_[i];
  influenced_.resize(first_influenced_.back());
  std::vector<std::uint32_t> next = first_influenced_;
  for (std::uint32_t v = 0; v < skeleton_.vertex_count(); ++v) {
    for (const Influence& influence : skeleton_.influences_of(v)) influenced_[next[position_[influence.joint]]++] = v;
  }
}

void JointFollowers::find_drivers() {
  drives_.assign(values_.size(), false);
  const std::size_t first = rig_.first_parameter(rig_.layers().size());
  std::vector<std::uint32_t> all(rig_.vertex_count());
  for (std::uint32_t v = 0; v < all.size(); ++v) all[v] = v;
  for (const auto& layer : rig_.layers()) {
    if (!layer->driven()) continue;
    const auto bound = layer->bind(all);
    for (std::size_t p = 0; p < drives_.size(); ++p) {
      if (bound->moves(first + p)) drives_[p] = true;
    }
  }
}

std::span<const std::uint32_t> JointFollowers::of(std::uint32_t joint) {
  asked_ = std::span(order_).subspan(position_[joint], below_[joint]);
  vertices_.clear();
  if (asked_.empty()) return vertices_;
  std::size_t first_word = marked_.size();
  std::size_t last_word = 0;
  const std::uint32_t end = first_influenced_[position_[joint] + below_[joint]];
  for (std::uint32_t i = first_influenced_[position_[joint]]; i < end; ++i) {
    const std::size_t word = influenced_[i] / 64;
    marked_[word] |= std::uint64_t{1} << (influenced_[i] % 64);
    first_word = std::min(first_word, word);
    last_word = std::max(last_word, word);
  }
  for (std::size_t word = first_word; word <= last_word; ++word) {
    for (std::uint64_t& bits = marked_[word]; bits != 0; bits &= bits - 1)
      vertices_.push_back(static_cast<std::uint32_t>(64 * word) + static_cast<std::uint32_t>(std::countr_zero(bits)));
  }
  return vertices_;
}

void JointFollowers::turn(std::size_t parameter, double value, std::span<ModelPoint> places) {
  if (asked_.empty()) return;
  if (turned_.data() != asked_.data()) posed_.turn(values_, turned_);
  turned_ = asked_;
  values_[parameter] = value;
  posed_.turn(values_, turned_);
  values_[parameter] = 0.0;
  for (std::size_t k = 0; k < vertices_.size(); ++k) {
    const std::uint32_t v = vertices_[k];
    places[k] = carried(skeleton_.vertex_matrix(v, posed_.matrices()), displaced_[v]);
  }
}

}  // namespace penpose::rig
