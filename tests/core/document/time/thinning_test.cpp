#include "core/document/time/thinning.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "core/document/time/timeline.h"
#include "tests/support/random.h"

namespace penpose::document {
namespace {

struct Take {
  std::vector<double> times_s, values, tolerances;
  [[nodiscard]] DenseCurves dense() const { return {times_s, values, tolerances}; }
};

/// So many frames of 24 a second; a value a curve at each moment.
template <class Function>
Take take_of(std::size_t frames, std::vector<double> tolerances, Function value) {
  Take take;
  take.tolerances = std::move(tolerances);
  for (std::size_t f = 0; f < frames; ++f) {
    take.times_s.push_back(static_cast<double>(f) / 24);
    for (std::size_t c = 0; c < take.tolerances.size(); ++c) take.values.push_back(value(take.times_s.back(), c));
  }
  return take;
}

/// The farthest that the timeline of the kept moments is off at any frame, in tolerances.
double worst_of(const Take& take, const std::vector<std::size_t>& kept) {
  const std::size_t count = take.tolerances.size();
  Timeline timeline;
  for (const std::size_t m : kept) {
    const auto row = take.values.begin() + static_cast<std::ptrdiff_t>(m * count);
    timeline.keys.push_back({take.times_s[m], rig::Pose(row, row + static_cast<std::ptrdiff_t>(count)), ""});
  }
  double worst = 0;
  for (std::size_t m = 0; m < take.times_s.size(); ++m) {
    const rig::Pose pose = sample(timeline, take.times_s[m], rig::Pose(timeline.keys.front().pose.size(), 0.0));
    for (std::size_t c = 0; c < count; ++c)
      worst = std::max(worst, std::abs(pose[c] - take.values[m * count + c]) / take.tolerances[c]);
  }
  return worst;
}

double wave(double time_s, std::size_t curve) {
  return 0.5 + 0.4 * std::sin((1.7 + 0.6 * static_cast<double>(curve)) * time_s);
}

TEST(Thinning, OfSmoothCurvesAFifthOfTheFramesIsEnough) {
  const Take take = take_of(120, {0.02, 0.03}, wave);
  const auto kept = enough_moments(take.dense());
  EXPECT_LE(kept.size(), 24U);
  EXPECT_GE(kept.size(), 4U) << "they go up and down";
  EXPECT_EQ(kept.front(), 0U);
  EXPECT_EQ(kept.back(), 119U);
  EXPECT_LE(worst_of(take, kept), 1 + 1e-9);
}

TEST(Thinning, EveryFrameOfTremblingCurvesIsWithinTheTolerance) {
  std::mt19937_64 numbers(7);
  for (int round = 0; round < 20; ++round) {
    double at = 0;
    const Take take = take_of(90, {0.01, 0.05, 0.3}, [&](double time_s, std::size_t curve) {
      at = std::clamp(at + 0.1 * (static_cast<double>(numbers() >> 11) * 0x1p-53 - 0.5), -1.0, 1.0);
      return curve == 1 ? at : wave(time_s, curve);
    });
    const auto kept = enough_moments(take.dense());
    EXPECT_LE(worst_of(take, kept), 1 + 1e-9) << round;
    EXPECT_LT(kept.size(), 90U) << round;
    for (std::size_t k = 1; k + 1 < kept.size(); ++k) {
      auto fewer = kept;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(k));
      EXPECT_GT(worst_of(take, fewer), 1 - 1e-9) << "moment " << kept[k] << " is not needed";
    }
  }
}

TEST(Thinning, WhatHoldsStillHasItsEndsAlone) {
  const Take take = take_of(76, {0.01}, [](double, std::size_t) { return 0.4; });
  EXPECT_EQ(enough_moments(take.dense()), (std::vector<std::size_t>{0, 75}));
}

TEST(Thinning, AHoldBetweenTwoMovesStaysAHold) {
  const Take take = take_of(61, {0.01}, [](double time_s, std::size_t) {
    const double u = std::clamp(time_s < 1.25 ? time_s : 2.5 - time_s, 0.0, 0.5) / 0.5;
    return u * u * (3 - 2 * u);
  });
  const auto kept = enough_moments(take.dense());
  EXPECT_LE(kept.size(), 8U);
  EXPECT_LE(worst_of(take, kept), 1 + 1e-9);
}

TEST(Thinning, FixedMomentsStay) {
  const Take take = take_of(40, {10}, wave);
  const std::vector<std::size_t> fixed{7, 23};
  EXPECT_EQ(enough_moments(take.dense(), fixed), (std::vector<std::size_t>{0, 7, 23, 39}));
}

TEST(Thinning, OneMomentAndNoneAreKept) {
  EXPECT_EQ(enough_moments(take_of(1, {1}, wave).dense()), (std::vector<std::size_t>{0}));
  EXPECT_TRUE(enough_moments(take_of(0, {1}, wave).dense()).empty());
}

}  // namespace
}  // namespace penpose::document
