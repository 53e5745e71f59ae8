#include "core/intent/reading/value_search.h"

#include <algorithm>

#include "core/algebra/vectors.h"
#include "core/posing/objective.h"

namespace penpose::intent {
namespace {

/// The energy of a choice in u = 0..1 between the ends of each variable's range.
class ChoiceObjective final : public posing::Objective {
 public:
  ChoiceObjective(Reader& reader, const Quadratic& quadratic, const ChoiceCosts& costs, const Choice& choice)
      : reader_(reader), quadratic_(quadratic), costs_(costs), choice_(choice) {}

  [[nodiscard]] std::size_t dimension() const override { return choice_.variables.size(); }
  [[nodiscard]] std::size_t image_size() const override { return reader_.linear() ? quadratic_.right().size() : 0; }
  void make_image(std::span<const double> u, std::span<double> image) override {
    if (image.empty()) return;
    for (std::size_t k = 0; k < image.size(); ++k) image[k] = -quadratic_.right()[k];
    for (std::size_t i = 0; i < u.size(); ++i) add(i, value(i, u[i]), image);
  }
  void shift_image(std::size_t i, double delta, std::span<double> image) override {
    if (!image.empty()) add(i, delta * extent(i), image);
  }
  double value(std::span<const double> u, std::span<const double> image) override {
    for (std::size_t i = 0; i < u.size(); ++i) choice_.values[i] = value(i, u[i]);
    const double cost = costs_.costs_of(choice_);
    if (!reader_.linear()) return reader_.energy(choice_, cost);
    double sum = reader_.energy_of_image(image, quadratic_.rows()) + cost;
    for (std::size_t i = 0; i < u.size(); ++i)
      sum += reader_.choices().stiffness[choice_.variables[i]] * choice_.values[i] * choice_.values[i];
    return sum;
  }

  [[nodiscard]] double value(std::size_t i, double u) const {
    return reader_.choices().low[choice_.variables[i]] + u * extent(i);
  }
  [[nodiscard]] double share(std::size_t i, double value) const {
    return std::clamp((value - reader_.choices().low[choice_.variables[i]]) / extent(i), 0.0, 1.0);
  }

 private:
  [[nodiscard]] double extent(std::size_t i) const {
    const std::size_t v = choice_.variables[i];
    return reader_.choices().high[v] - reader_.choices().low[v];
  }
  void add(std::size_t i, double by, std::span<double> image) const {
    const auto column = quadratic_.column(choice_.variables[i]);
    algebra::add_scaled(by, column.data(), image.data(), image.size());
  }

  Reader& reader_;
  const Quadratic& quadratic_;
  const ChoiceCosts& costs_;
  Choice choice_;
};

}  // namespace

std::size_t search_values(Reader& reader, const Quadratic& quadratic, const ChoiceCosts& costs, Choice& choice,
                          std::size_t most, posing::SimplexWorkspace& work) {
  const std::size_t n = choice.variables.size();
  if (n == 0 || n > 12) return 0;
  ChoiceObjective objective(reader, quadratic, costs, choice);
  std::vector<double> u(n);
  for (std::size_t i = 0; i < n; ++i) u[i] = objective.share(i, choice.values[i]);
  std::vector<double> image(objective.image_size());
  objective.make_image(u, image);
  const double before = objective.value(u, image);
  posing::SimplexOptions options;
  options.step = 0.04;
  options.size_tolerance = 1e-4;
  options.value_tolerance = 1e-5;
  options.max_evaluations = most;
  const auto found = posing::run_simplex(objective, options, u, image, work);
  if (found.value < before) {
    for (std::size_t i = 0; i < n; ++i) choice.values[i] = objective.value(i, u[i]);
    choice.costs = costs.costs_of(choice) + costs.limit_costs(choice);
  }
  return found.evaluations;
}

}  // namespace penpose::intent
