#pragma once

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <memory>
#include <string>
#include <vector>

#include "core/geometry/rotation.h"
#include "core/rig/character_rig.h"

namespace penpose::tests {

/// A body made of tubes around bones, one joint each. Joints stand in frames of their own that have nothing to do with
/// their bones, and everything may be scaled: nothing may depend on either.
class StickFigure {
 public:
  explicit StickFigure(double unit = 1, bool odd_frames = true) : unit_(unit), odd_frames_(odd_frames) {}

  /// A joint at `from` whose bone ends at `to`. A radius of 0: it carries nothing.
  std::size_t add(std::int32_t parent, geometry::ModelPoint from, geometry::ModelPoint to, double radius = 0.04) {
    bones_.push_back({parent, from, to, radius});
    return bones_.size() - 1;
  }
  /// A joint on a bone that takes this share of its skin, from its middle on.
  std::size_t add_helper(std::size_t bone, double share) {
    const Bone b = bones_[bone];
    const std::size_t helper = add(static_cast<std::int32_t>(bone), (b.from + b.to) * 0.5, b.to, 0);
    bones_[bone].helper = helper;
    bones_[bone].helper_share = share;
    return helper;
  }
  void limit(std::size_t joint, glm::dvec3 minimum, glm::dvec3 maximum) {
    bones_[joint].minimum = minimum;
    bones_[joint].maximum = maximum;
  }

  [[nodiscard]] std::shared_ptr<const rig::Skeleton> skeleton() const { return make().second; }
  [[nodiscard]] std::shared_ptr<const rig::CharacterRig> rig() const {
    auto [mesh, skeleton] = make();
    return rig::CharacterRig::make(mesh, {}, skeleton).value();
  }
  /// Vertices along a bone on the side towards +z, from its beginning to its end.
  [[nodiscard]] std::vector<std::uint32_t> along(std::size_t bone) const {
    std::uint32_t first = 0;
    for (std::size_t b = 0; b < bone; ++b) first += bones_[b].radius > 0 ? k_rings * k_around : 0;
    std::vector<std::uint32_t> out;
    for (std::uint32_t r = 0; r < k_rings; ++r) out.push_back(first + r * k_around);
    return out;
  }
  /// The joint's frame in the world at rest.
  [[nodiscard]] glm::dquat frame(std::size_t joint) const {
    const auto j = static_cast<double>(joint);
    return odd_frames_ ? geometry::quaternion_from_xyz({1.1 * j, 0.7 + 0.4 * j, 2.0 - 0.9 * j})
                       : glm::dquat(1, 0, 0, 0);
  }
  /// The three parameters of a joint that is turned about an axis of the world.
  [[nodiscard]] glm::dvec3 angles(std::size_t joint, geometry::ModelVector axis, double angle) const {
    const geometry::ModelVector v = axis * std::sin(angle / 2);
    const glm::dquat q = frame(joint);
    return geometry::xyz_from_quaternion(glm::conjugate(q) * glm::dquat(std::cos(angle / 2), v.x, v.y, v.z) * q);
  }

 private:
  static constexpr std::uint32_t k_rings = 9;
  static constexpr std::uint32_t k_around = 6;
  struct Bone {
    std::int32_t parent;
    geometry::ModelPoint from, to;
    double radius;
    std::size_t helper = 0;
    double helper_share = 0;
    glm::dvec3 minimum = rig::Joint{}.minimum, maximum = rig::Joint{}.maximum;
  };

  [[nodiscard]] std::pair<std::shared_ptr<const mesh::TriangleMesh>, std::shared_ptr<const rig::Skeleton>> make()
      const {
    mesh::MeshSource source;
    std::vector<rig::Joint> joints;
    std::vector<std::uint32_t> first{0};
    std::vector<rig::Influence> influences;
    std::vector<glm::dmat4> world;
    for (std::size_t b = 0; b < bones_.size(); ++b) {
      const Bone& bone = bones_[b];
      world.push_back(geometry::compose(bone.from * unit_, frame(b), {1, 1, 1}));
      rig::Joint joint;
      joint.name = "j" + std::to_string(b);
      joint.parent = bone.parent;
      joint.minimum = bone.minimum;
      joint.maximum = bone.maximum;
      joint.inverse_bind = glm::inverse(world[b]);
      const glm::dmat4 before = bone.parent < 0 ? glm::dmat4(1) : world[static_cast<std::size_t>(bone.parent)];
      const glm::dquat turn = bone.parent < 0 ? glm::dquat(1, 0, 0, 0) : frame(static_cast<std::size_t>(bone.parent));
      joint.translation = glm::dvec3((glm::inverse(before) * world[b])[3]);
      joint.rest_rotation = glm::conjugate(turn) * frame(b);
      joints.push_back(joint);
      if (bone.radius > 0) add_tube(source, first, influences, b);
    }
    return {mesh::TriangleMesh::build(std::move(source)).value(),
            rig::Skeleton::make(joints, first, influences).value()};
  }

  void add_tube(mesh::MeshSource& source, std::vector<std::uint32_t>& first, std::vector<rig::Influence>& influences,
                std::size_t b) const {
    const Bone& bone = bones_[b];
    const auto base = static_cast<std::uint32_t>(source.positions.size());
    const geometry::ModelVector way = glm::normalize(bone.to - bone.from);
    const geometry::ModelVector side =
        glm::normalize(glm::cross(way, std::abs(way.z) < 0.9 ? glm::dvec3{0, 0, 1} : glm::dvec3{0, 1, 0}));
    const geometry::ModelVector front = glm::cross(side, way);
    for (std::uint32_t r = 0; r < k_rings; ++r) {
      const double t = static_cast<double>(r) / (k_rings - 1);
      for (std::uint32_t k = 0; k < k_around; ++k) {
        const double a = 2.0 * 3.14159265358979 * k / k_around;
        source.positions.push_back(
            (bone.from + (bone.to - bone.from) * t + (front * std::cos(a) + side * std::sin(a)) * bone.radius) * unit_);
        const double before = bone.parent >= 0 && bones_[static_cast<std::size_t>(bone.parent)].radius > 0
                                  ? std::max(0.0, 0.5 - 2 * t)
                                  : 0.0;
        const double helped = t >= 0.5 ? bone.helper_share : 0.0;
        influences.push_back({static_cast<std::uint32_t>(b), (1 - before) * (1 - helped)});
        if (before > 0) influences.push_back({static_cast<std::uint32_t>(bone.parent), before});
        if (helped > 0) influences.push_back({static_cast<std::uint32_t>(bone.helper), (1 - before) * helped});
        first.push_back(static_cast<std::uint32_t>(influences.size()));
        if (r + 1 == k_rings) continue;
        const std::uint32_t i = base + r * k_around + k;
        const std::uint32_t j = base + r * k_around + (k + 1) % k_around;
        source.triangles.push_back({i, j, j + k_around});
        source.triangles.push_back({i, j + k_around, i + k_around});
      }
    }
  }

  double unit_;
  bool odd_frames_;
  std::vector<Bone> bones_;
};

/// Hips 0, spine 1 to 4, head 5; left arm 6, 7, 8 and leg 9, 10, 11 (bent a little at elbow and knee), right arm 12,
/// 13, 14. 1.7 units high, seen from +z.
inline StickFigure stick_man(double unit = 1, bool odd_frames = true) {
  StickFigure man(unit, odd_frames);
  man.add(-1, {0, 0.9, 0}, {0, 1.0, 0}, 0.1);
  for (int k = 0; k < 4; ++k) man.add(k, {0, 1.0 + 0.12 * k, 0}, {0, 1.12 + 0.12 * k, 0}, 0.1);
  man.add(4, {0, 1.48, 0}, {0, 1.7, 0}, 0.07);
  man.add(4, {0.15, 1.45, 0}, {0.42, 1.40, 0});
  man.add(6, {0.42, 1.40, 0}, {0.68, 1.36, 0.06});
  man.add(7, {0.68, 1.36, 0.06}, {0.80, 1.34, 0.09}, 0.03);
  man.add(0, {0.1, 0.88, 0}, {0.1, 0.48, 0.03}, 0.06);
  man.add(9, {0.1, 0.48, 0.03}, {0.1, 0.08, 0}, 0.05);
  man.add(10, {0.1, 0.08, 0}, {0.1, 0.03, 0.14}, 0.03);
  man.add(4, {-0.15, 1.45, 0}, {-0.42, 1.40, 0});
  man.add(12, {-0.42, 1.40, 0}, {-0.68, 1.36, 0.06});
  man.add(13, {-0.68, 1.36, 0.06}, {-0.80, 1.34, 0.09}, 0.03);
  return man;
}

}  // namespace penpose::tests
