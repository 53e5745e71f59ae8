#include "core/posing/solution_state.h"

#include <algorithm>

namespace penpose::posing {

LinearSolution::LinearSolution(const LinearModel& model, std::vector<double>& u)
    : model_(model), u_(u), image_(model.at_zero.size()), trial_(model.at_zero.size()) {
  model_.residuals(u_, image_);
}

double LinearSolution::energy_without(std::size_t i) {
  ++evaluations_;
  std::copy(image_.begin(), image_.end(), trial_.begin());
  model_.columns[i].add_to(model_.variables.start[i] - u_[i], trial_.data());
  return weighted_lengths(trial_.data(), model_.weights, model_.softness);
}

void LinearSolution::put_back(std::size_t i) {
  model_.columns[i].add_to(model_.variables.start[i] - u_[i], image_.data());
  u_[i] = model_.variables.start[i];
}

GeneralSolution::GeneralSolution(CurveSystem& system, const Variables& variables, std::span<const double> start,
                                 std::vector<double>& u)
    : system_(system),
      variables_(variables),
      start_(start),
      u_(u),
      pose_(start.begin(), start.end()),
      image_(system.residual_count()) {
  for (std::size_t i = 0; i < u_.size(); ++i) {
    if (changed(i)) pose_[variables_.parameter[i]] = variables_.value(i, u_[i]);
  }
}

double GeneralSolution::energy() {
  ++evaluations_;
  system_.residuals(pose_, image_);
  return system_.energy(image_);
}

double GeneralSolution::energy_without(std::size_t i) {
  double& value = pose_[variables_.parameter[i]];
  const double kept = value;
  value = start_[variables_.parameter[i]];
  const double result = energy();
  value = kept;
  return result;
}

void GeneralSolution::put_back(std::size_t i) {
  pose_[variables_.parameter[i]] = start_[variables_.parameter[i]];
  u_[i] = variables_.start[i];
}

}  // namespace penpose::posing
