#pragma once

#include <array>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/rig/rig.h"

namespace penpose::rig {

/// One node of the tree that carries vertices. A posable joint has three parameters NAME.rx, NAME.ry, NAME.rz in
/// radians: its local rotation is rest_rotation * Rx * Ry * Rz, so that the axes are the joint's own.
struct Joint {
  std::string name;
  std::int32_t parent = -1;  ///< comes before its children; -1 for a root
  glm::dvec3 translation{0};
  glm::dquat rest_rotation{1, 0, 0, 0};
  glm::dvec3 scale{1};
  glm::dmat4 inverse_bind{1};  ///< from the space of the rest vertices to the joint's own
  bool posable = true;
  glm::dvec3 minimum{-1.57079632679489662};  ///< radians, about x, y, z
  glm::dvec3 maximum{1.57079632679489662};
};

/// Share of one joint in one vertex.
struct Influence {
  std::uint32_t joint = 0;
  double weight = 0;
};

/// Where a matrix takes a point.
[[nodiscard]] inline ModelPoint carried(const glm::dmat4& matrix, const ModelPoint& p) {
  return ModelPoint(matrix * glm::dvec4(p, 1.0));
}

/// Linear blend skinning. Vertex v is carried by influences[first_influence[v] .. first_influence[v + 1]); weights sum
/// to one, and a vertex without influences stays where it is.
class Skeleton {
 public:
  /// Errors (place "joint N" or "vertex N"): a parent that does not come before its child, numbers that are not finite,
  /// a joint that does not exist, weights that are negative or all zero (others are scaled to sum to one).
  static base::Result<std::shared_ptr<const Skeleton>> make(std::vector<Joint> joints,
                                                            std::vector<std::uint32_t> first_influence,
                                                            std::vector<Influence> influences);

  [[nodiscard]] std::span<const Joint> joints() const { return joints_; }
  [[nodiscard]] std::size_t vertex_count() const { return first_influence_.size() - 1; }
  [[nodiscard]] std::span<const Influence> influences_of(std::uint32_t vertex) const;
  [[nodiscard]] std::span<const Parameter> parameters() const { return parameters_; }
  /// The number of the joint that a parameter turns.
  [[nodiscard]] std::uint32_t joint_of(std::size_t parameter) const { return posable_[parameter / 3]; }

  /// Matrix of every joint from rest-vertex space to world, at the parameter values. Precondition: one place a joint.
  void joint_matrices(std::span<const double> values, std::span<glm::dmat4> matrices) const;
  /// The blended matrix of one vertex.
  [[nodiscard]] glm::dmat4 vertex_matrix(std::uint32_t vertex, std::span<const glm::dmat4> matrices) const;

 private:
  std::vector<Joint> joints_;
  std::vector<std::uint32_t> first_influence_;
  std::vector<Influence> influences_;
  friend class PosedJoints;
  /// Of a joint in its parent's space, at its angles (rad).
  [[nodiscard]] glm::dmat4 local_matrix(std::size_t joint, const glm::dvec3& angles) const;

  std::vector<std::uint32_t> posable_;          ///< numbers of the posable joints
  std::vector<std::uint32_t> first_parameter_;  ///< of each joint; of one that is not posable, that of the next
  std::vector<glm::dmat4> rest_locals_;         ///< local matrices at rest
  std::vector<Parameter> parameters_;
};

/// Matrices of joints that remember the last pose: a turn costs what hangs below it. The same bits as
/// Skeleton::joint_matrices. The skeleton must outlive it.
class PosedJoints {
 public:
  /// `wanted`: one a joint; what carries a wanted joint is wanted. Others have no matrix.
  PosedJoints(const Skeleton& skeleton, std::vector<bool> wanted);
  /// Takes the parameter values of the skeleton.
  void turn(std::span<const double> values) { turn(values, wanted_); }
  /// The same where no joint outside of `joints`, wanted ones each after its parent, is turned otherwise than before,
  /// nor hangs below one of them.
  void turn(std::span<const double> values, std::span<const std::uint32_t> joints);
  /// Whether the last turn changed a joint's matrix.
  [[nodiscard]] bool changed(std::uint32_t joint) const { return changed_[joint]; }
  [[nodiscard]] std::span<const glm::dmat4> matrices() const { return matrices_; }

 private:
  const Skeleton& skeleton_;
  std::vector<std::uint32_t> wanted_;
  std::vector<double> values_;
  std::vector<glm::dmat4> worlds_, matrices_;
  std::vector<bool> changed_;
  bool made_ = false;
};

}  // namespace penpose::rig
