#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/posing/curve_system.h"
#include "core/posing/objective.h"

namespace penpose::posing {

/// Two variables that undo each other, such as closing a lid and opening it wide.
struct Opposed {
  std::size_t a = 0;
  std::size_t b = 0;
  double share = 0;  ///< 0..1; all shares of a variable add up to 1 at most
};

/// The variables of a solve: some parameters of the rig, each scaled so that its range is 0..1.
struct Variables {
  std::vector<std::size_t> parameter;
  std::vector<double> minimum;
  std::vector<double> range;
  std::vector<double> start;  ///< u at the start of the solve; the staying-near term pulls to it
  std::vector<Opposed> opposed;
  std::vector<double> opposed_from;  ///< origin of u for opposed variables, one value a variable
  double opposed_weight = 1;         ///< 0..1, times the shares

  [[nodiscard]] std::size_t count() const { return parameter.size(); }
  [[nodiscard]] double value(std::size_t i, double u) const { return minimum[i] + u * range[i]; }
};
[[nodiscard]] Variables make_variables(const rig::Rig& rig, std::span<const std::size_t> parameters,
                                       std::span<const double> pose);

/// The part of the staying-near term for opposed variables: opposed_weight times the sum of
/// 2 share (u_a - from_a) (u_b - from_b). Moving both the same way costs more than moving one. If all shares of a
/// variable add up to 1 at most, the whole term stays convex.
[[nodiscard]] double opposed_term(const Variables& variables, std::span<const double> u);

/// E(x) + near_weight * (sum (u_i - start_i)^2 + opposed_term) over a chosen subset of the variables, with the
/// others at `at`.
class PoseObjective : public Objective {
 public:
  /// Chooses the subset that the next simplex moves. `at` holds all variables.
  virtual void select(std::span<const std::size_t> subset, std::span<const double> at) = 0;
};

/// The objective of a rig that is linear in all variables: its image is the residuals themselves, so that a value
/// costs O(points) whatever the number of variables.
struct LinearModel {
  Variables variables;
  std::vector<Column> columns;  ///< one a variable, change of the residuals when u goes from 0 to 1
  Residuals at_zero;            ///< residuals at u = 0
  std::vector<double> weights;  ///< of the points, padded
  double near_weight = 0;
  double softness = 0;  ///< of the lengths (weighted_lengths), in units of the model

  void residuals(std::span<const double> u, std::span<double> out) const;
};
/// `columns` are those of CurveSystem for the variables' parameters; the other parameters stay at `pose`.
[[nodiscard]] LinearModel make_linear_model(CurveSystem& system, std::span<const double> pose, Variables variables,
                                            std::vector<Column> columns, double near_weight);
/// The model must outlive it.
[[nodiscard]] std::unique_ptr<PoseObjective> make_linear_objective(const LinearModel& model);

/// The objective of any rig, a black box. Both references must outlive it.
[[nodiscard]] std::unique_ptr<PoseObjective> make_general_objective(CurveSystem& system, const Variables& variables,
                                                                    std::span<const double> pose, double near_weight);

}  // namespace penpose::posing
