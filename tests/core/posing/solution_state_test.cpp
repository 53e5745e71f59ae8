#include "core/posing/solution_state.h"

#include <gtest/gtest.h>

#include "tests/support/models/posing_problems.h"

namespace penpose::posing {
namespace {

/// Both states of one solution: u at random, two variables where they started.
struct Solved {
  tests::Sheet sheet{9, 5};
  PoseProblem problem = sheet.problem(rig::Pose(9, 0.4));
  CurveSystem system{*sheet.rig, problem};
  Variables variables;
  LinearModel model;
  std::vector<double> u;

  Solved() {
    tests::Random random(3);
    for (double& x : problem.start) x = random(0, 1);
    variables = make_variables(*sheet.rig, problem.free, problem.start);
    model = make_linear_model(system, problem.start, variables, system.columns(problem.start, problem.free).value(), 0);
    for (std::size_t i = 0; i < 9; ++i) u.push_back(i % 4 == 1 ? variables.start[i] : random(0, 1));
  }
  [[nodiscard]] double energy_at(const std::vector<double>& at) {
    rig::Pose pose = problem.start;
    for (std::size_t i = 0; i < at.size(); ++i) pose[i] = variables.value(i, at[i]);
    Residuals residuals(system.residual_count());
    system.residuals(pose, residuals);
    return system.energy(residuals);
  }
};

template <typename State>
void expect_reverts(Solved& s, State& state) {
  EXPECT_EQ(state.count(), 9U);
  EXPECT_NEAR(state.energy(), s.energy_at(s.u), 1e-10);
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_EQ(state.changed(i), i % 4 != 1) << i;
    auto without = s.u;
    without[i] = s.variables.start[i];
    EXPECT_NEAR(state.energy_without(i), s.energy_at(without), 1e-10);
    EXPECT_NEAR(state.energy(), s.energy_at(s.u), 1e-10) << "asking changes nothing";
  }
  for (const std::size_t i : {4U, 0U, 7U}) {
    state.put_back(i);
    EXPECT_EQ(s.u[i], s.variables.start[i]);
    EXPECT_FALSE(state.changed(i));
    EXPECT_NEAR(state.energy(), s.energy_at(s.u), 1e-10);
  }
  auto without = s.u;
  without[3] = s.variables.start[3];
  EXPECT_NEAR(state.energy_without(3), s.energy_at(without), 1e-10) << "with those before it";
  EXPECT_GE(state.evaluations(), 10U);
}

TEST(LinearSolution, TakesVariablesOut) {
  Solved s;
  LinearSolution state(s.model, s.u);
  expect_reverts(s, state);
}

TEST(GeneralSolution, TakesVariablesOut) {
  Solved s;
  GeneralSolution state(s.system, s.variables, s.problem.start, s.u);
  expect_reverts(s, state);
}

}  // namespace
}  // namespace penpose::posing
