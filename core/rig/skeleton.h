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
  std::vector<std::uint32_t> posable_;  ///< numbers of the posable joints
  std::vector<Parameter> parameters_;
};

}  // namespace penpose::rig
