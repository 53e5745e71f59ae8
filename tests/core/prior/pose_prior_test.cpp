#include "core/prior/pose_prior.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "core/base/numbers.h"
#include "tests/support/models/test_rigs.h"

namespace penpose::prior {
namespace {

std::vector<rig::Parameter> parameters(std::size_t count) {
  std::vector<rig::Parameter> out(count);
  for (std::size_t i = 0; i < count; ++i) out[i].name = "p" + std::to_string(i);
  return out;
}

/// Keys that follow a few moods, with a little of their own.
std::vector<rig::Pose> moods(std::size_t keys, std::size_t count, std::size_t moods, double own, std::uint64_t seed) {
  tests::Random random(seed);
  std::vector<std::vector<double>> mixes(moods);
  for (auto& mix : mixes) {
    for (std::size_t i = 0; i < count; ++i) mix.push_back(random(0, 1.2 / static_cast<double>(moods)));
  }
  std::vector<rig::Pose> out(keys, rig::Pose(count, 0.0));
  for (auto& key : out) {
    for (const auto& mix : mixes) {
      const double much = random(0, 0.8);
      for (std::size_t i = 0; i < count; ++i) key[i] += much * mix[i];
    }
    for (double& value : key) value = std::clamp(value + random(-own, own), 0.0, 1.0);
  }
  return out;
}

/// The conditional mean from the covariance in full, by Gaussian elimination, which the module never makes.
std::vector<double> dense(const PosePrior& prior, const rig::Pose& pose, const std::vector<std::size_t>& held) {
  const std::size_t p = prior.varied.size();
  std::vector<std::vector<double>> c(p, std::vector<double>(p, 0.0));
  for (std::size_t i = 0; i < p; ++i) {
    for (std::size_t j = 0; j < p; ++j) {
      for (std::size_t s = 0; s < prior.samples; ++s) {
        c[i][j] += prior.deviations[s * p + i] * prior.deviations[s * p + j] / static_cast<double>(prior.samples);
      }
      c[i][j] = (1 - prior.shrinkage) * c[i][j] + (i == j ? prior.shrinkage * prior.spread : 0);
    }
  }
  std::vector<std::size_t> known;
  for (std::size_t i = 0; i < p; ++i) {
    if (std::find(held.begin(), held.end(), prior.varied[i]) != held.end()) known.push_back(i);
  }
  const std::size_t k = known.size();
  std::vector<std::vector<double>> a(k, std::vector<double>(k + 1));
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = 0; j < k; ++j) a[i][j] = c[known[i]][known[j]];
    a[i][k] = pose[prior.varied[known[i]]] - prior.mean[known[i]];
  }
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t r = 0; r < k; ++r) {
      if (r == i) continue;
      const double share = a[r][i] / a[i][i];
      for (std::size_t j = i; j <= k; ++j) a[r][j] -= share * a[i][j];
    }
  }
  std::vector<double> out = prior.mean;
  for (std::size_t i = 0; i < p; ++i) {
    for (std::size_t j = 0; j < k; ++j) out[i] += c[i][known[j]] * a[j][k] / a[j][j];
  }
  return out;
}

TEST(PosePrior, OfTwoNumbersTheConditionalMeanIsTheLineOfRegression) {
  // Means 0.4 and 0.5; X'X/n = [0.04 0.03; 0.03 0.09].
  PosePrior prior;
  prior.varied = {0, 2};
  prior.samples = 2;
  prior.mean = {0.4, 0.5};
  const double b = std::sqrt(0.09 - 0.0225);
  prior.deviations = {0.2 * std::sqrt(2), 0.15 * std::sqrt(2), 0, b * std::sqrt(2)};
  prior.shrinkage = 0.2;
  prior.spread = 0.065;
  const std::vector<std::size_t> held{0};
  const auto pose = suggest(prior, parameters(3), {0.7, 0.3, 0.1}, held);
  ASSERT_TRUE(pose.ok());
  EXPECT_EQ((*pose)[0], 0.7) << "held";
  EXPECT_EQ((*pose)[1], 0.3) << "never varied";
  EXPECT_NEAR((*pose)[2], 0.5 + 0.8 * 0.03 / (0.8 * 0.04 + 0.2 * 0.065) * 0.3, 1e-14);
}

TEST(PosePrior, BothWaysOfSolvingAreTheConditionalMeanOfTheFullCovariance) {
  constexpr std::size_t k_count = 24;
  const auto all = parameters(k_count);
  for (const std::size_t keys : {4U, 9U, 60U}) {
    const auto poses = moods(keys, k_count, 3, 0.05, keys);
    const auto prior = learn(all, poses);
    ASSERT_TRUE(prior.ok());
    EXPECT_GT(prior->shrinkage, 0);
    EXPECT_LT(prior->shrinkage, 1);
    const rig::Pose now = moods(1, k_count, 3, 0.05, 99).front();
    std::vector<std::size_t> held;
    // Fewer and more than there are samples.
    for (std::size_t i = 0; i < k_count; i += 2) {
      held.push_back(i);
      const auto pose = suggest(*prior, all, now, held);
      ASSERT_TRUE(pose.ok());
      const auto expected = dense(*prior, now, held);
      for (std::size_t v = 0; v < prior->varied.size(); ++v) {
        const std::size_t i2 = prior->varied[v];
        if (std::find(held.begin(), held.end(), i2) != held.end()) {
          EXPECT_EQ((*pose)[i2], now[i2]);
        } else if (std::abs(expected[v] - now[i2]) > k_least_change + 1e-9) {
          EXPECT_NEAR((*pose)[i2], std::clamp(expected[v], 0.0, 1.0), 1e-10) << keys << " keys, " << held.size();
        }
      }
    }
  }
}

TEST(PosePrior, MeanAndCovarianceAreThoseOfTheKeysAndTheRestPose) {
  auto all = parameters(2);
  all[1].minimum = -1;
  all[1].rest = -0.5;
  const auto prior = learn(all, std::vector<rig::Pose>{{0.9, 1}, {0.3, -1}});
  ASSERT_TRUE(prior.ok());
  EXPECT_EQ(prior->keys, 2U);
  EXPECT_EQ(prior->samples, 3U);
  EXPECT_NEAR(prior->mean[0], 1.2 / 3, 1e-15);
  EXPECT_NEAR(prior->mean[1], (1 + 0 + 0.25) / 3, 1e-15) << "shares of the range";
  const double trace = (0.5 * 0.5 + 0.1 * 0.1 + 0.4 * 0.4 + 7.0 / 12 * 7.0 / 12 + 5.0 / 12 * 5.0 / 12 + 1.0 / 36) / 3;
  EXPECT_NEAR(prior->spread, trace / 2, 1e-15);
  // A key at rest is the rest pose, which counts once.
  EXPECT_EQ(learn(all, std::vector<rig::Pose>{{0.9, 1}, {0, -0.5}})->samples, 2U);
}

TEST(PosePrior, NeitherTheOrderOfKeysNorCopiesChangeABit) {
  const auto all = parameters(12);
  auto poses = moods(9, 12, 2, 0.1, 5);
  const rig::Pose now = moods(1, 12, 2, 0.1, 6).front();
  const std::vector<std::size_t> held{1, 4, 5};
  const auto first = suggest(*learn(all, poses), all, now, held).value();
  for (int turn = 0; turn < 8; ++turn) {
    std::rotate(poses.begin(), poses.begin() + 1 + turn % 3, poses.end());
    std::swap(poses[0], poses[static_cast<std::size_t>(turn)]);
    EXPECT_EQ(suggest(*learn(all, poses), all, now, held).value(), first) << turn;
  }
  poses.push_back(poses[3]);
  poses.push_back(poses[3]);
  EXPECT_EQ(suggest(*learn(all, poses), all, now, held).value(), first) << "a pose that is held is one pose";
  EXPECT_EQ(learn(all, poses)->keys, 9U);
}

// The bits themselves, as any machine and any version shall find them.
TEST(PosePrior, GivesTheSameBitsEverywhere) {
  const auto all = parameters(4);
  const std::vector<rig::Pose> keys{
      {0.1, 0.1, 0.05, 0.3}, {0.5, 0.4, 0.2, 0.1}, {0.9, 0.75, 0.45, 0.3}, {0.3, 0.35, 0.1, 0.2}, {0.7, 0.6, 0.3, 0.1}};
  const auto prior = learn(all, keys);
  ASSERT_TRUE(prior.ok());
  const auto pose = suggest(*prior, all, {0.85, 0, 0, 0.3}, std::vector<std::size_t>{0, 3}).value();
  EXPECT_EQ(base::format_double(prior->shrinkage), "0.349309301621484");
  EXPECT_EQ(base::format_double(pose[1]), "0.6504383990722251");
  EXPECT_EQ(base::format_double(pose[2]), "0.352016435117236");
}

TEST(PosePrior, StrengthIsAShareOfTheWayAndNothingLeavesItsRange) {
  auto all = parameters(10);
  for (auto& one : all) one.maximum = 0.6;
  const auto poses = moods(7, 10, 2, 0.3, 11);
  std::vector<rig::Pose> within = poses;
  for (auto& pose : within) {
    for (double& value : pose) value = std::min(value, 0.6);
  }
  const auto prior = learn(all, within);
  ASSERT_TRUE(prior.ok());
  rig::Pose now(10, 0.0);
  now[2] = now[3] = 0.6;
  const std::vector<std::size_t> held{2, 3};
  const auto whole = suggest(*prior, all, now, held, 1).value();
  const auto half = suggest(*prior, all, now, held, 0.5).value();
  EXPECT_EQ(suggest(*prior, all, now, held, 0).value(), now);
  EXPECT_NE(whole, now);
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_GE(whole[i], 0);
    EXPECT_LE(whole[i], 0.6);
    const double moved = whole[i] - now[i];
    EXPECT_TRUE(moved == 0 || std::abs(moved) >= k_least_change * 0.6) << "no hair is moved";
    EXPECT_TRUE(half[i] == now[i] || std::abs(half[i] - now[i] - 0.5 * moved) < 1e-12) << i;
  }
}

TEST(PosePrior, WhatCannotBeLearnedFromIsRefusedWithARemedy) {
  const auto all = parameters(2);
  const auto refused = [&](const std::vector<rig::Pose>& keys) {
    const auto prior = learn(all, keys);
    EXPECT_FALSE(prior.ok());
    return prior.ok() ? std::string() : prior.error().line();
  };
  const std::string remedy = "; key two different poses or more, from which the rest can be learned";
  EXPECT_EQ(refused({}), "no pose is keyed yet" + remedy);
  EXPECT_EQ(refused({{0.5, 0.5}}), "only one pose is keyed yet" + remedy);
  EXPECT_EQ(refused({{0.5, 0.5}, {0.5, 0.5}}), "all keys hold one pose" + remedy);
  EXPECT_EQ(refused({{0.5, 0.5}, {0.50001, 0.5}}), "the keys differ in nothing that can be seen" + remedy);
  EXPECT_EQ(refused({{0.5, 0.5}, {0.5}}), "key 2: has 1 values for 2 parameters; give one value a parameter");
  EXPECT_EQ(refused({{0.5, 0.5}, {0.5, std::numeric_limits<double>::quiet_NaN()}}),
            "key 2: the value of \"p1\" is no number; key that pose again");
  // A control with a range of nothing says nothing, and stays.
  auto still = parameters(3);
  still[1].maximum = 0;
  const auto prior = learn(still, std::vector<rig::Pose>{{0.5, 0, 0.2}, {0.1, 0, 0.9}});
  ASSERT_TRUE(prior.ok());
  EXPECT_EQ(prior->varied, (std::vector<std::size_t>{0, 2}));
  const auto nothing = suggest(*prior, still, {0.1, 0, 0}, std::vector<std::size_t>{1});
  ASSERT_FALSE(nothing.ok());
  EXPECT_NE(nothing.error().what.find("no key moves what is posed now"), std::string::npos);
}

}  // namespace
}  // namespace penpose::prior
