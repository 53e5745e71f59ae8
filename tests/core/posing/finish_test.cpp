#include "core/posing/finish.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "tests/support/models/posing_problems.h"

namespace penpose::posing {
namespace {

/// A model by hand: `points` residuals, made of at_zero[i] + sum over j of u_j columns[j][i].
LinearModel model_of(const std::vector<ModelPoint>& at_zero, const std::vector<std::vector<ModelPoint>>& columns,
                     const std::vector<double>& weights = {}) {
  const std::size_t blocks = (at_zero.size() + k_block_points - 1) / k_block_points;
  const auto laid_out = [&](const std::vector<ModelPoint>& points) {
    Residuals residuals(blocks * k_block_numbers, 0.0);
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        residuals[residual_index(i, axis)] = points[i][static_cast<int>(axis)];
    }
    return residuals;
  };
  LinearModel model;
  model.at_zero = laid_out(at_zero);
  for (std::size_t j = 0; j < columns.size(); ++j) {
    model.columns.emplace_back(laid_out(columns[j]));
    model.variables.parameter.push_back(j);
    model.variables.minimum.push_back(0);
    model.variables.range.push_back(1);
    model.variables.start.push_back(0);
  }
  model.weights.assign(blocks * k_block_points, 0.0);
  for (std::size_t i = 0; i < at_zero.size(); ++i) model.weights[i] = weights.empty() ? 1.0 : weights[i];
  return model;
}

double energy(const LinearModel& model, std::span<const double> u) {
  Residuals residuals(model.at_zero.size());
  model.residuals(u, residuals);
  return weighted_lengths(residuals.data(), model.weights, model.softness);
}

FinishOptions long_run() {
  FinishOptions options;
  options.max_iterations = 500;
  options.gain_tolerance = 0;
  return options;
}

TEST(Finish, OnALineItFindsTheMedian) {
  // sum |u - t_i|: the least sum of distances is at the median, here 0.3, not at the mean, 0.446.
  std::vector<ModelPoint> at_zero;
  for (const double t : {0.05, 0.28, 0.3, 0.7, 0.9}) at_zero.emplace_back(-t, 0, 0);
  const auto model = model_of(at_zero, {std::vector<ModelPoint>(5, {1, 0, 0})});
  std::vector<double> u{0.8};
  FinishWorkspace work;
  const auto result = finish_linear(model, long_run(), u, work);
  EXPECT_NEAR(u[0], 0.3, 1e-3);
  EXPECT_NEAR(result.value, 0.25 + 0.02 + 0.4 + 0.6, 1e-3);
  EXPECT_NEAR(result.value, energy(model, u), 1e-12);
}

TEST(Finish, InAPlaneItFindsTheGeometricMedian) {
  // The corners of a triangle whose angles are below 120 degrees: the Fermat point sees each pair at 120 degrees.
  const std::vector<ModelPoint> corners{{0.1, 0.1, 0}, {0.9, 0.2, 0}, {0.4, 0.8, 0}};
  std::vector<ModelPoint> at_zero;
  for (const ModelPoint& c : corners) at_zero.push_back(-c);
  const auto model = model_of(at_zero, {std::vector<ModelPoint>(3, {1, 0, 0}), std::vector<ModelPoint>(3, {0, 1, 0})});
  std::vector<double> u{0.9, 0.9};
  FinishWorkspace work;
  finish_linear(model, long_run(), u, work);
  const ModelPoint at{u[0], u[1], 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto a = geometry::normalized(corners[i] - at);
    const auto b = geometry::normalized(corners[(i + 1) % 3] - at);
    EXPECT_NEAR(a.x * b.x + a.y * b.y, -0.5, 0.01);
  }
}

TEST(Finish, SoftLengthsFindTheMeanOfWhatIsNearAndTheMedianOfWhatIsFar) {
  // Targets within a hundredth of the softness: least squares. One far off pulls no harder than one nearby would.
  std::vector<ModelPoint> at_zero;
  for (const double t : {0.50, 0.51, 0.55}) at_zero.emplace_back(-t, 0, 0);
  auto model = model_of(at_zero, {std::vector<ModelPoint>(3, {1, 0, 0})});
  model.softness = 5;
  std::vector<double> u{0.9};
  FinishWorkspace work;
  finish_linear(model, long_run(), u, work);
  EXPECT_NEAR(u[0], 0.52, 1e-3);
  model.softness = 1e-3;
  u[0] = 0.9;
  const auto result = finish_linear(model, long_run(), u, work);
  EXPECT_NEAR(u[0], 0.51, 2e-3);
  EXPECT_NEAR(result.value, energy(model, u), 1e-12);
}

TEST(Finish, TheTermOfAPairIsPartOfTheEnergy) {
  // Two independent variables that would like to be at 0.5 each; a pair holds them by their sum, too.
  const auto found = [](double share) {
    auto model = model_of({{-0.5, 0, 0}, {0, -0.5, 0}}, {{{1, 0, 0}, {0, 0, 0}}, {{0, 0, 0}, {0, 1, 0}}});
    model.softness = 10;  // near its bottom the energy is (d1^2 + d2^2) / 20
    model.near_weight = 0.05;
    model.variables.opposed_from = {0, 0};
    if (share > 0) model.variables.opposed = {{0, 1, share}};
    std::vector<double> u{0.3, 0.3};
    FinishWorkspace work;
    finish_linear(model, long_run(), u, work);
    return u;
  };
  // (u - 0.5) / 10 + 0.1 (u + share u) = 0.
  for (const double share : {0.0, 0.5, 1.0}) {
    const auto u = found(share);
    EXPECT_NEAR(u[0], 0.5 / (2 + share), 1e-3) << share;
    EXPECT_NEAR(u[1], u[0], 1e-3) << share;
  }
}

TEST(Finish, AHeavierPointPullsHarder) {
  const auto model = model_of({{-0.2, 0, 0}, {-0.7, 0, 0}}, {std::vector<ModelPoint>(2, {1, 0, 0})}, {1, 1.5});
  std::vector<double> u{0};
  FinishWorkspace work;
  finish_linear(model, long_run(), u, work);
  EXPECT_NEAR(u[0], 0.7, 1e-3);
}

TEST(Finish, StaysInTheBox) {
  const auto model = model_of({{-3, 0.5, 0}, {-4, 0, 0}},
                              {std::vector<ModelPoint>(2, {1, 0, 0}), std::vector<ModelPoint>(2, {0, 1, 0})});
  std::vector<double> u{0.5, 0.5};
  FinishWorkspace work;
  finish_linear(model, long_run(), u, work);
  EXPECT_EQ(u[0], 1);
  EXPECT_NEAR(u[1], 0, 1e-6);
}

TEST(Finish, HeedsThePullToTheStart) {
  // Between two points any place has the same sum of distances: the pull chooses the one nearest the start, 0.
  auto model = model_of({{-0.2, 0, 0}, {-0.8, 0, 0}}, {std::vector<ModelPoint>(2, {1, 0, 0})});
  model.near_weight = 0.05;
  std::vector<double> u{0.7};
  FinishWorkspace work;
  const auto result = finish_linear(model, long_run(), u, work);
  EXPECT_NEAR(u[0], 0.2, 1e-3);
  EXPECT_NEAR(result.value, 0.6 + 0.05 * 0.04, 1e-4);
}

TEST(Finish, NeverGetsWorseFromAnyStart) {
  tests::Random random(4);
  FinishWorkspace work;
  for (int run = 0; run < 60; ++run) {
    const std::size_t points = 1 + random.index(15);
    const std::size_t d = 1 + random.index(12);
    const double size = run % 3 == 0 ? 1e-6 : run % 3 == 1 ? 1.0 : 1e6;
    std::vector<ModelPoint> at_zero;
    for (std::size_t i = 0; i < points; ++i) at_zero.push_back(random.vector(size));
    std::vector<std::vector<ModelPoint>> columns(d);
    for (auto& column : columns) {
      for (std::size_t i = 0; i < points; ++i)
        column.push_back(random.index(3) == 0 ? ModelPoint{0} : ModelPoint(random.vector(size)));
    }
    const auto model = model_of(at_zero, columns);
    std::vector<double> u;
    for (std::size_t j = 0; j < d; ++j) u.push_back(random.index(4) == 0 ? 0.0 : random(0, 1));
    const double before = energy(model, u);
    const auto result = finish_linear(model, FinishOptions{}, u, work);
    EXPECT_LE(result.value, before);
    EXPECT_NEAR(energy(model, u), result.value, 1e-9 * before);
    EXPECT_LE(result.iterations, FinishOptions{}.max_iterations);
    for (const double x : u) {
      EXPECT_GE(x, 0);
      EXPECT_LE(x, 1);
    }
    // No single variable alone can do much better: the energy is convex.
    const auto best = finish_linear(model, long_run(), u, work);
    for (std::size_t j = 0; j < d; ++j) {
      for (const double x : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        auto trial = u;
        trial[j] = x;
        EXPECT_GE(energy(model, trial), best.value * (1 - 1e-3)) << "variable " << j << " at " << x;
      }
    }
  }
}

TEST(Finish, AFitStays) {
  auto model = model_of({{-0.5, 0, 0}, {-0.5, 0, 0}}, {std::vector<ModelPoint>(2, {1, 0, 0})});
  std::vector<double> u{0.5};
  FinishWorkspace work;
  EXPECT_EQ(finish_linear(model, {}, u, work).value, 0);
  EXPECT_EQ(u[0], 0.5);
}

}  // namespace
}  // namespace penpose::posing
