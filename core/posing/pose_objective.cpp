#include "core/posing/pose_objective.h"

#include <algorithm>

namespace penpose::posing {
namespace {

/// near_weight * (sum (u_i - start_i)^2 over the subset + opposed_term). `all`: every variable; those of the subset are
/// brought to `u` first.
double near_term(const Variables& variables, std::span<const std::size_t> subset, std::span<const double> u,
                 std::span<double> all, double near_weight) {
  double sum = 0;
  if (!variables.opposed.empty()) {
    for (std::size_t i = 0; i < subset.size(); ++i) all[subset[i]] = u[i];
    sum = opposed_term(variables, all);
  }
  for (std::size_t i = 0; i < subset.size(); ++i) {
    const double d = u[i] - variables.start[subset[i]];
    sum += d * d;
  }
  return near_weight * sum;
}

class LinearObjective final : public PoseObjective {
 public:
  explicit LinearObjective(const LinearModel& model) : model_(model) {}

  void select(std::span<const std::size_t> subset, std::span<const double> at) override {
    subset_.assign(subset.begin(), subset.end());
    at_.assign(at.begin(), at.end());
  }
  [[nodiscard]] std::size_t dimension() const override { return subset_.size(); }
  [[nodiscard]] std::size_t image_size() const override { return model_.at_zero.size(); }
  void make_image(std::span<const double> u, std::span<double> image) override {
    for (std::size_t i = 0; i < subset_.size(); ++i) at_[subset_[i]] = u[i];
    model_.residuals(at_, image);
  }
  void shift_image(std::size_t i, double delta, std::span<double> image) override {
    model_.columns[subset_[i]].add_to(delta, image.data());
  }
  double value(std::span<const double> u, std::span<const double> image) override {
    const double fit = weighted_lengths(image.data(), model_.weights, model_.softness);
    return model_.near_weight > 0.0 ? fit + near_term(model_.variables, subset_, u, at_, model_.near_weight) : fit;
  }

 private:
  const LinearModel& model_;
  std::vector<std::size_t> subset_;
  std::vector<double> at_;
};

class GeneralObjective final : public PoseObjective {
 public:
  GeneralObjective(CurveSystem& system, const Variables& variables, std::span<const double> pose, double near_weight)
      : system_(system),
        variables_(variables),
        pose_(pose.begin(), pose.end()),
        residuals_(system.residual_count()),
        near_weight_(near_weight) {}

  void select(std::span<const std::size_t> subset, std::span<const double> at) override {
    subset_.assign(subset.begin(), subset.end());
    at_.assign(at.begin(), at.end());
    for (std::size_t i = 0; i < at.size(); ++i) pose_[variables_.parameter[i]] = variables_.value(i, at[i]);
  }
  [[nodiscard]] std::size_t dimension() const override { return subset_.size(); }
  [[nodiscard]] std::size_t image_size() const override { return 0; }
  void make_image(std::span<const double>, std::span<double>) override {}
  void shift_image(std::size_t, double, std::span<double>) override {}
  double value(std::span<const double> u, std::span<const double>) override {
    for (std::size_t i = 0; i < subset_.size(); ++i)
      pose_[variables_.parameter[subset_[i]]] = variables_.value(subset_[i], u[i]);
    system_.residuals(pose_, residuals_);
    return system_.energy(residuals_) + near_term(variables_, subset_, u, at_, near_weight_);
  }

 private:
  CurveSystem& system_;
  const Variables& variables_;
  rig::Pose pose_;
  Residuals residuals_;
  double near_weight_;
  std::vector<std::size_t> subset_;
  std::vector<double> at_;
};

}  // namespace

double opposed_term(const Variables& variables, std::span<const double> u) {
  double sum = 0;
  for (const Opposed& pair : variables.opposed) {
    const double a = u[pair.a] - variables.opposed_from[pair.a];
    sum += 2.0 * pair.share * a * (u[pair.b] - variables.opposed_from[pair.b]);
  }
  return variables.opposed_weight * sum;
}

Variables make_variables(const rig::Rig& rig, std::span<const std::size_t> parameters, std::span<const double> pose) {
  Variables variables;
  for (const std::size_t p : parameters) {
    const rig::Parameter& parameter = rig.parameters()[p];
    variables.parameter.push_back(p);
    variables.minimum.push_back(parameter.minimum);
    variables.range.push_back(parameter.maximum - parameter.minimum);
    variables.start.push_back(
        std::clamp((pose[p] - parameter.minimum) / (parameter.maximum - parameter.minimum), 0.0, 1.0));
  }
  return variables;
}

LinearModel make_linear_model(CurveSystem& system, std::span<const double> pose, Variables variables,
                              std::vector<Column> columns, double near_weight) {
  LinearModel model;
  model.weights.assign(system.weights().begin(), system.weights().end());
  model.near_weight = near_weight;
  model.softness = system.softness();
  rig::Pose zero(pose.begin(), pose.end());
  for (std::size_t j = 0; j < variables.count(); ++j) {
    zero[variables.parameter[j]] = variables.minimum[j];
    columns[j].scale(variables.range[j]);
  }
  model.at_zero.resize(system.residual_count());
  system.residuals(zero, model.at_zero);
  model.columns = std::move(columns);
  model.variables = std::move(variables);
  return model;
}

void LinearModel::residuals(std::span<const double> u, std::span<double> out) const {
  std::copy(at_zero.begin(), at_zero.end(), out.begin());
  for (std::size_t j = 0; j < columns.size(); ++j) {
    if (u[j] != 0.0) columns[j].add_to(u[j], out.data());
  }
}

std::unique_ptr<PoseObjective> make_linear_objective(const LinearModel& model) {
  return std::make_unique<LinearObjective>(model);
}

std::unique_ptr<PoseObjective> make_general_objective(CurveSystem& system, const Variables& variables,
                                                      std::span<const double> pose, double near_weight) {
  return std::make_unique<GeneralObjective>(system, variables, pose, near_weight);
}

}  // namespace penpose::posing
