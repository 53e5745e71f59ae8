#pragma once

#include <span>
#include <vector>

#include "core/posing/clean_up.h"
#include "core/posing/curve_system.h"
#include "core/posing/pose_objective.h"

namespace penpose::posing {

/// A solution of a linear model whose variables can be reset; updates its residuals.
class LinearSolution final : public Revertible {
 public:
  /// Changes `u` in place. Both references must outlive it.
  LinearSolution(const LinearModel& model, std::vector<double>& u);
  [[nodiscard]] std::size_t count() const override { return u_.size(); }
  [[nodiscard]] bool changed(std::size_t i) const override { return u_[i] != model_.variables.start[i]; }
  double energy_without(std::size_t i) override;
  void put_back(std::size_t i) override;
  /// Plain energy, without the staying-near term.
  [[nodiscard]] double energy() const { return weighted_lengths(image_.data(), model_.weights, model_.softness); }
  [[nodiscard]] std::size_t evaluations() const { return evaluations_; }

 private:
  const LinearModel& model_;
  std::vector<double>& u_;
  Residuals image_;
  Residuals trial_;
  std::size_t evaluations_ = 0;
};

/// The same for any rig, with an evaluation for every query.
class GeneralSolution final : public Revertible {
 public:
  GeneralSolution(CurveSystem& system, const Variables& variables, std::span<const double> start,
                  std::vector<double>& u);
  [[nodiscard]] std::size_t count() const override { return u_.size(); }
  [[nodiscard]] bool changed(std::size_t i) const override { return u_[i] != variables_.start[i]; }
  double energy_without(std::size_t i) override;
  void put_back(std::size_t i) override;
  [[nodiscard]] double energy();
  [[nodiscard]] std::size_t evaluations() const { return evaluations_; }

 private:
  CurveSystem& system_;
  const Variables& variables_;
  std::span<const double> start_;
  std::vector<double>& u_;
  rig::Pose pose_;
  Residuals image_;
  std::size_t evaluations_ = 0;
};

}  // namespace penpose::posing
