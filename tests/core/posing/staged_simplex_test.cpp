#include "core/posing/staged_simplex.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>

#include "tests/support/models/test_rigs.h"

namespace penpose::posing {
namespace {

using Function = std::function<double(std::span<const double>)>;

/// Any function of all variables; notes what it was asked for.
class Plain final : public PoseObjective {
 public:
  explicit Plain(Function function) : function_(std::move(function)) {}
  void select(std::span<const std::size_t> subset, std::span<const double> at) override {
    subset_.assign(subset.begin(), subset.end());
    at_.assign(at.begin(), at.end());
    stages.push_back(subset_);
  }
  [[nodiscard]] std::size_t dimension() const override { return subset_.size(); }
  [[nodiscard]] std::size_t image_size() const override { return 0; }
  void make_image(std::span<const double>, std::span<double>) override {}
  void shift_image(std::size_t, double, std::span<double>) override {}
  double value(std::span<const double> u, std::span<const double>) override {
    ++evaluations;
    for (std::size_t i = 0; i < u.size(); ++i) {
      EXPECT_GE(u[i], 0.0);
      EXPECT_LE(u[i], 1.0);
      at_[subset_[i]] = u[i];
    }
    return function_(at_);
  }
  std::size_t evaluations = 0;
  std::vector<std::vector<std::size_t>> stages;

 private:
  Function function_;
  std::vector<std::size_t> subset_;
  std::vector<double> at_;
};

/// Distance to a point, plus a pull between neighbours, so that no variable stands alone.
Function bowl(std::vector<double> bottom) {
  return [bottom = std::move(bottom)](std::span<const double> u) {
    double sum = 0;
    for (std::size_t i = 0; i < u.size(); ++i) {
      const double d = u[i] - bottom[i];
      const double next = i + 1 < u.size() ? u[i + 1] - bottom[i + 1] : 0;
      sum += d * d + 0.5 * (d - next) * (d - next);
    }
    return sum;
  };
}

std::vector<double> somewhere(std::size_t count, std::uint64_t seed) {
  tests::Random random(seed);
  std::vector<double> u;
  for (std::size_t i = 0; i < count; ++i) u.push_back(random(0.1, 0.9));
  return u;
}

TEST(StagedSimplex, SearchesFewVariablesTogetherAndRestarts) {
  const auto bottom = somewhere(6, 1);
  Plain objective(bowl(bottom));
  std::vector<double> u(6, 0.5);
  StageWorkspace work;
  const auto result = run_stages(objective, std::vector<double>(6, 1.0), {}, u, work);
  EXPECT_LT(result.value, 1e-4);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(u[i], bottom[i], 0.01);
  EXPECT_GE(objective.stages.size(), 2U) << "a fresh simplex from the best point, until it no longer gains";
  for (const auto& stage : objective.stages) EXPECT_EQ(stage.size(), 6U);
  EXPECT_EQ(result.evaluations, objective.evaluations);
}

TEST(StagedSimplex, SearchesManyVariablesAFewAtATimeFromTheLargestEffectDown) {
  const std::size_t d = 40;
  const auto bottom = somewhere(d, 2);
  Plain objective(bowl(bottom));
  std::vector<double> effects;
  for (std::size_t i = 0; i < d; ++i) effects.push_back(static_cast<double>((i * 17) % d));
  std::vector<double> u(d, 0.5);
  const double before = bowl(bottom)(u);
  StageWorkspace work;
  const auto result = run_stages(objective, effects, {}, u, work);
  EXPECT_LT(result.value, 0.01 * before);
  EXPECT_NEAR(bowl(bottom)(u), result.value, 1e-12);
  // The first sweep goes once through all variables in order of their effects.
  std::vector<std::size_t> sweep;
  for (std::size_t s = 0; sweep.size() < d; ++s) {
    EXPECT_LE(objective.stages[s].size(), StageOptions{}.stage_size);
    sweep.insert(sweep.end(), objective.stages[s].begin(), objective.stages[s].end());
  }
  ASSERT_EQ(sweep.size(), d);
  for (std::size_t i = 1; i < d; ++i) EXPECT_GT(effects[sweep[i - 1]], effects[sweep[i]]);
  EXPECT_GT(result.sweeps, 1U);
}

TEST(StagedSimplex, NeverGetsWorseAndKeepsItsBudget) {
  for (const std::size_t d : {1U, 5U, 23U, 120U}) {
    for (const std::size_t budget : {0U, 1U, 10U, 100U, 300U}) {
      Plain objective([](std::span<const double> u) {
        double sum = 0;
        for (std::size_t i = 0; i < u.size(); ++i) sum += std::sin(30 * u[i] + static_cast<double>(i)) + u[i];
        return sum;
      });
      std::vector<double> u = somewhere(d, 3);
      const std::vector<double> start = u;
      StageOptions options;
      options.max_evaluations = budget;
      StageWorkspace work;
      const auto result = run_stages(objective, std::vector<double>(d, 1.0), options, u, work);
      EXPECT_LE(result.evaluations, budget) << d << " variables";
      EXPECT_EQ(result.evaluations, objective.evaluations);
      const auto value = [](const std::vector<double>& at) {
        double sum = 0;
        for (std::size_t i = 0; i < at.size(); ++i) sum += std::sin(30 * at[i] + static_cast<double>(i)) + at[i];
        return sum;
      };
      EXPECT_LE(value(u), value(start));
    }
  }
}

TEST(StagedSimplex, AFitAtTheStartStays) {
  const auto bottom = somewhere(30, 4);
  Plain objective(bowl(bottom));
  std::vector<double> u = bottom;
  StageWorkspace work;
  run_stages(objective, std::vector<double>(30, 1.0), {}, u, work);
  EXPECT_EQ(u, bottom);
}

}  // namespace
}  // namespace penpose::posing
