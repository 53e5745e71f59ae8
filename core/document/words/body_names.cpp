#include "core/document/words/body_names.h"

#include <algorithm>
#include <array>
#include <string>

namespace penpose::document {
namespace {

using geometry::ModelPoint;
using Joints = std::vector<std::size_t>;

constexpr std::size_t k_least_joints = 10;

/// Finds the parts of a figure.
class Figure {
 public:
  Figure(const intent::WholeModel& whole, const portrait::FaceFrame& front)
      : whole_(whole), body_(*whole.body), names_(body_.size()) {
    for (const joints::Place& place : body_.rest()) places_.push_back(front.local(place.at));
  }

  std::vector<std::optional<NamedJoint>> take() {
    if (!find_ends()) return std::vector<std::optional<NamedJoint>>(body_.size());
    name_spine();
    for (std::size_t side = 0; side < 2; ++side) {
      const FaceSide own = side == 0 ? FaceSide::left : FaceSide::right;
      name_leg(way(hips_, feet_[side]), own);
      name_arm(way(chest_, hands_[side]), own);
    }
    return std::move(names_);
  }

 private:
  [[nodiscard]] bool carries(std::size_t joint) const {
    return joint < whole_.joint_extents.size() && whole_.joint_extents[joint] > 0.0 && !body_.helper(joint);
  }

  /// The joint from which the way to two joints is the same, the last one.
  [[nodiscard]] std::optional<std::size_t> fork(std::size_t a, std::size_t b) const {
    const Joints one = way(std::nullopt, a);
    const Joints other = way(std::nullopt, b);
    std::optional<std::size_t> last;
    for (std::size_t k = 0; k < std::min(one.size(), other.size()) && one[k] == other[k]; ++k) last = one[k];
    return last;
  }

  /// The joints from one, which is left out, down to another, without helpers.
  [[nodiscard]] Joints way(std::optional<std::size_t> from, std::size_t to) const {
    Joints out;
    for (auto j = static_cast<std::int32_t>(to); j >= 0; j = body_.parent(static_cast<std::size_t>(j))) {
      const auto joint = static_cast<std::size_t>(j);
      if (from == joint) break;
      if (!body_.helper(joint)) out.push_back(joint);
    }
    std::reverse(out.begin(), out.end());
    return out;
  }

  /// The joint that has most of something, of those that carry vertices and are wanted.
  template <typename Value, typename Wanted>
  [[nodiscard]] std::optional<std::size_t> most(const Value& value, const Wanted& wanted) const {
    std::optional<std::size_t> best;
    for (std::size_t j = 0; j < body_.size(); ++j) {
      if (carries(j) && wanted(j) && (!best || value(j) > value(*best))) best = j;
    }
    return best;
  }

  bool find_ends() {
    if (body_.size() < k_least_joints) return false;
    geometry::Box box;
    for (std::size_t j = 0; j < body_.size(); ++j) {
      if (carries(j)) box.add(places_[j]);
    }
    if (box.empty()) return false;
    const double middle = box.center().x;
    const auto all = [](std::size_t) { return true; };
    for (std::size_t side = 0; side < 2; ++side) {
      const double out = side == 0 ? 1.0 : -1.0;
      const auto foot = most([&](std::size_t j) { return -places_[j].y; },
                             [&](std::size_t j) { return out * (places_[j].x - middle) > 0.02 * box.diagonal(); });
      const auto hand = most([&](std::size_t j) { return out * places_[j].x; }, all);
      if (!foot || !hand) return false;
      feet_[side] = *foot;
      hands_[side] = *hand;
    }
    const auto hips = fork(feet_[0], feet_[1]);
    const auto chest = fork(hands_[0], hands_[1]);
    const auto top = most([&](std::size_t j) { return places_[j].y; }, all);
    if (!hips || !chest || !top || *hips == *chest || places_[*hips].y >= places_[*chest].y) return false;
    hips_ = *hips;
    chest_ = *chest;
    top_ = *top;
    return is_figure();
  }

  /// Arms hang on the chest, which stands on the hips, and the head is above both; limbs come in two alike.
  [[nodiscard]] bool is_figure() const {
    const Joints up = way(hips_, chest_);
    const Joints head = way(chest_, top_);
    if (up.empty() || up.back() != chest_ || head.empty()) return false;
    const std::array<Joints, 2> legs{way(hips_, feet_[0]), way(hips_, feet_[1])};
    const std::array<Joints, 2> arms{way(chest_, hands_[0]), way(chest_, hands_[1])};
    if (legs[0].size() != legs[1].size() || arms[0].size() != arms[1].size()) return false;
    if (legs[0].size() < 2 || arms[0].size() < 2) return false;
    for (std::size_t side = 0; side < 2; ++side) {
      if (legs[side].front() == up.front() || arms[side].front() == head.front()) return false;
    }
    return true;
  }

  void set(std::size_t joint, const std::string& what, FaceSide side, JointKind kind) {
    if (names_[joint]) return;
    names_[joint] = NamedJoint{{what, side}, kind};
  }

  void name_spine() {
    set(hips_, "hips", FaceSide::both, JointKind::middle);
    set(chest_, "chest", FaceSide::both, JointKind::middle);
    for (const std::size_t j : way(hips_, chest_)) set(j, "spine", FaceSide::both, JointKind::middle);
    const Joints up = way(chest_, top_);
    if (up.size() == 1) return set(up[0], "head", FaceSide::both, JointKind::head);
    set(up[0], "neck", FaceSide::both, JointKind::head);
    set(up[1], "head", FaceSide::both, JointKind::head);
  }

  void name_leg(Joints joints, FaceSide side) {
    constexpr std::array<const char*, 4> k_parts{"upper leg", "lower leg", "foot", "toes"};
    while (joints.size() < k_parts.size() && !body_.branches(joints.back()).empty())
      joints.push_back(body_.branches(joints.back())[0]);
    for (std::size_t k = 0; k < std::min(joints.size(), k_parts.size()); ++k)
      set(joints[k], k_parts[k], side, JointKind::limb);
  }

  void name_arm(const Joints& joints, FaceSide side) {
    constexpr std::array<const char*, 4> k_parts{"shoulder", "upper arm", "lower arm", "hand"};
    std::size_t hand = 0;
    while (hand + 1 < joints.size() && body_.branches(joints[hand]).size() < 3) ++hand;
    if (hand > 3 || hand < 1) return;
    // Two joints without fingers are an arm without a hand.
    const std::size_t first = hand == 1 && body_.branches(joints[hand]).size() < 3 ? 1 : 3 - hand;
    for (std::size_t k = 0; k <= hand; ++k) set(joints[k], k_parts[k + first], side, JointKind::limb);
    name_fingers(joints[hand], side);
  }

  void name_fingers(std::size_t hand, FaceSide side) {
    constexpr std::array<const char*, 5> k_fingers{"thumb", "index finger", "middle finger", "ring finger",
                                                   "little finger"};
    constexpr std::array<const char*, 3> k_parts{" base", " middle", " tip"};
    const auto branches = body_.branches(hand);
    Joints fingers(branches.begin(), branches.end());
    // The thumb begins nearest to the wrist, and the others follow it.
    const auto nearest = [&](std::size_t joint) {
      std::stable_sort(fingers.begin(), fingers.end(), [&](std::size_t a, std::size_t b) {
        return geometry::distance(places_[a], places_[joint]) < geometry::distance(places_[b], places_[joint]);
      });
    };
    nearest(hand);
    if (!fingers.empty()) nearest(fingers.front());
    for (std::size_t f = 0; f < fingers.size(); ++f) {
      const std::string what = fingers.size() == 5 ? k_fingers[f] : "finger";
      std::optional<std::size_t> j = fingers[f];
      for (std::size_t k = 0; j && k < k_parts.size(); ++k) {
        set(*j, what + k_parts[k], side, JointKind::finger);
        const auto next = body_.branches(*j);
        j = next.empty() ? std::nullopt : std::optional(next[0]);
      }
    }
  }

  const intent::WholeModel& whole_;
  const joints::Body& body_;
  std::vector<std::optional<NamedJoint>> names_;
  std::vector<ModelPoint> places_;
  std::size_t hips_ = 0, chest_ = 0, top_ = 0;
  std::array<std::size_t, 2> feet_{}, hands_{};
};

}  // namespace

std::vector<std::optional<NamedJoint>> names_by_shape(const intent::WholeModel& whole,
                                                      const portrait::FaceFrame& front) {
  return Figure(whole, front).take();
}

}  // namespace penpose::document
