#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/posing/problem.h"
#include "core/posing/vector_math.h"
#include "core/rig/rig.h"

namespace penpose::posing {

/// The curve points of a problem, all pairs then all constraints, bound to the vertices under them. An evaluation
/// touches those vertices only, never the whole mesh. Holds scratch memory: one object for each thread. The rig must
/// outlive it.
class CurveSystem {
 public:
  /// Precondition: check_problem passed.
  CurveSystem(const rig::Rig& rig, const PoseProblem& problem);

  [[nodiscard]] std::size_t point_count() const { return targets_.size(); }
  /// Size of Residuals for these points.
  [[nodiscard]] std::size_t residual_count() const { return 3 * weights_.size(); }
  /// w_i of every point, padded with zeros to whole blocks.
  [[nodiscard]] std::span<const double> weights() const { return weights_; }
  /// Changes target and weight of one point, for a target that is still being drawn. Precondition: the point exists;
  /// weight >= 0.
  void set_target(std::size_t point, const ModelPoint& target) { targets_[point] = target; }
  void set_weight(std::size_t point, double weight) { weights_[point] = weight; }
  /// Below this length residuals count as squares (weighted_lengths); 0 by default.
  void set_softness(double length) { softness_ = length; }
  [[nodiscard]] double softness() const { return softness_; }
  [[nodiscard]] const rig::Rig& rig() const { return rig_; }
  [[nodiscard]] bool moves(std::size_t parameter) const { return bound_->moves(parameter); }

  /// The residuals r_i - t_i at a pose, from the rig itself. Precondition: residual_count() places.
  void residuals(std::span<const double> pose, std::span<double> out);
  /// The position of every curve point at a pose.
  void positions(std::span<const double> pose, std::span<ModelPoint> out);
  /// Sum of weighted lengths: the energy, without the staying-near term.
  [[nodiscard]] double energy(std::span<const double> residuals) const;
  /// Length of the longest residual of a point with nonzero weight.
  [[nodiscard]] double longest(std::span<const double> residuals) const;

  /// One column a free parameter: how the residuals change when the parameter moves by one. Nothing when the rig is not
  /// linear in one of the free parameters.
  [[nodiscard]] std::optional<std::vector<Column>> columns(std::span<const double> pose,
                                                           std::span<const std::size_t> free);

 private:
  const rig::Rig& rig_;
  std::unique_ptr<rig::BoundVertices> bound_;
  std::vector<std::array<std::uint32_t, 3>> slots_;  ///< bound vertices of every point
  std::vector<std::array<double, 3>> shares_;
  std::vector<ModelPoint> targets_;
  std::vector<double> weights_;
  double softness_ = 0;
  std::vector<ModelPoint> vertex_positions_;
};

}  // namespace penpose::posing
