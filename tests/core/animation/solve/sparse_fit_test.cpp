#include "core/animation/solve/sparse_fit.h"

#include <gtest/gtest.h>

namespace penpose::animation {
namespace {

/// Three points that are to go by (0.5, 0); the first control moves all of them by (1, 0), the second one of them
/// alone.
SparseFit fit_of(double cost) {
  SparseFit fit;
  fit.points = 3;
  fit.columns = {1, 0, 1, 0, 1, 0, 1, 0, 0, 0, 0, 0};
  fit.at_zero = {-0.5, 0, -0.5, 0, -0.5, 0};
  fit.weights = {1, 1, 1};
  fit.cost = {cost, cost};
  fit.rest = fit.last = {0, 0};
  fit.softness = 0.01;
  fit.rounds = 50;
  return fit;
}

TEST(SparseFit, GoesWhereThePointsAreByTheControlThatMovesThemAll) {
  SparseWorkspace work;
  std::vector<double> u{0, 0};
  fit_sparsely(fit_of(0.05), u, work);
  EXPECT_NEAR(u[0], 0.5, 0.01);
  EXPECT_EQ(u[1], 0);  // not nearly: at rest
}

TEST(SparseFit, WhatCostsMoreThanItGainsStaysExactlyAtRest) {
  SparseWorkspace work;
  std::vector<double> u{0, 0};
  fit_sparsely(fit_of(10), u, work);
  EXPECT_EQ(u, (std::vector<double>{0, 0}));
}

TEST(SparseFit, StaysWithinItsRange) {
  SparseWorkspace work;
  std::vector<double> u{0, 0};
  SparseFit fit = fit_of(0.01);
  fit.at_zero = {-5, 0, -5, 0, -5, 0};
  fit_sparsely(fit, u, work);
  EXPECT_EQ(u[0], 1);
}

TEST(SparseFit, EvidencePullsTowardsWhatItSays) {
  SparseWorkspace work;
  std::vector<double> u{0, 0};
  SparseFit fit = fit_of(0.01);
  fit.at_zero = {0, 0, 0, 0, 0, 0};
  fit.told = {1000, 0};
  fit.wish = {0.3, 0};
  fit_sparsely(fit, u, work);
  EXPECT_NEAR(u[0], 0.3, 0.02);
}

TEST(SparseFit, TwinsShareEvenly) {
  SparseFit fit = fit_of(0.05);
  fit.columns = {1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0};
  const auto twins = find_twins(fit);
  ASSERT_EQ(twins.size(), 1U);
  std::vector<double> u{0.5, 0.1};
  share_evenly(twins, u);
  EXPECT_EQ(u[0], u[1]);
  EXPECT_NEAR(u[0] + u[1], 0.6, 1e-12);
  fit.cost[1] *= 2;
  EXPECT_TRUE(find_twins(fit).empty());
}

}  // namespace
}  // namespace penpose::animation
