#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "core/intent/solve.h"
#include "tests/core/intent/face.h"

// Why a line is read as it is, how likely readings are, and what choices of the artist change.

namespace penpose::intent {
namespace {

using inference::Weights;

/// A mouth that one shape lifts from above and another one from below, and a line that hardly tells them apart.
struct Mouth {
  tests::Face face;
  IntentProblem problem;
  WholeModel whole;
  SolveWorkspace work;

  Mouth() {
    face.bump("lift", 0, -0.2, {0, 0.16, 0}, 0.6);
    face.bump("push", 0, -0.62, {0, 0.16, 0}, 0.6);
    face.bump("nose", 0, 0.1, {0, 0.2, 0.1}, 0.4);
    face.ready();
    const auto line = face.seen(tests::Face::mouth(), face.pose({{"lift", 0.6}}));
    problem = face.problem({face.drawn(tests::Face::mouth(), tests::shaken(line, 0.7, 3))});
    whole = measure_whole_model(*face.rig);
  }
  [[nodiscard]] std::vector<ExplainedReading> explained(const Weights& weights, std::span<const rig::Pose> also = {}) {
    SolveOptions options;
    options.weights = &weights;
    return explain(*face.rig, whole, problem, options, work, also).value();
  }
  [[nodiscard]] Solution solved() {
    SolveOptions options;
    options.others = 4;
    return solve(*face.rig, whole, problem, options, work).value();
  }
};

TEST(Explain, EnergiesAreTheWeightedSumsOfTheirTermsAndGiveProbabilities) {
  Mouth mouth;
  const Weights& weights = inference::learned_weights();
  const auto readings = mouth.explained(weights);
  ASSERT_GE(readings.size(), 2U);
  double sum = 0;
  double before = 0;
  for (const ExplainedReading& one : readings) {
    EXPECT_NEAR(one.energy, weights.by.dot(one.terms), 1e-6);
    EXPECT_GE(one.energy, before) << "the best first";
    before = one.energy;
    sum += one.probability;
    EXPECT_NEAR(one.probability / readings[0].probability, std::exp(readings[0].energy - one.energy), 1e-9);
  }
  EXPECT_NEAR(sum, 1, 1e-9);
}

TEST(Explain, ControlsThatWereAskedForAreAReading) {
  Mouth mouth;
  const std::vector<rig::Pose> also{mouth.face.pose({{"push", 1}})};
  const auto readings = mouth.explained(inference::learned_weights(), also);
  const std::size_t push = mouth.face.number("push");
  EXPECT_TRUE(std::any_of(readings.begin(), readings.end(), [&](const ExplainedReading& one) {
    return one.pose[push] > 0 && one.pose[mouth.face.number("lift")] == 0;
  }));
}

TEST(Explain, ProbabilitiesOfWhatIsTakenAndOfferedAreNoMoreThanOne) {
  Mouth mouth;
  const Solution solution = mouth.solved();
  ASSERT_FALSE(solution.others.empty());
  double sum = solution.probability;
  EXPECT_NEAR(solution.others[0].probability / solution.probability, std::exp(-solution.others[0].above), 1e-6)
      << "each reading counts once";
  for (const OtherReading& one : solution.others) sum += one.probability;
  EXPECT_LE(sum, 1 + 1e-9);
  EXPECT_GT(sum, 0.99) << "there is nothing else";
}

TEST(Explain, AChoiceThatIsTaughtTurnsTheReading) {
  Mouth mouth;
  const Solution first = mouth.solved();
  const std::size_t lift = mouth.face.number("lift");
  const std::size_t push = mouth.face.number("push");
  ASSERT_EQ(first.moved, std::vector<std::size_t>{lift});
  const auto other = std::find_if(first.others.begin(), first.others.end(),
                                  [&](const OtherReading& one) { return one.pose[push] > 0 && one.pose[lift] == 0; });
  ASSERT_NE(other, first.others.end());
  mouth.problem.taught.assign(first.pose.size(), 0.0);
  mouth.problem.taught[lift] = 0.5 * (other->above + 1);
  mouth.problem.taught[push] = -0.5 * (other->above + 1);
  EXPECT_EQ(mouth.solved().moved, std::vector<std::size_t>{push});
  mouth.problem.taught[lift] = 0.4 * other->above;
  mouth.problem.taught[push] = -0.4 * other->above;
  EXPECT_EQ(mouth.solved().moved, std::vector<std::size_t>{lift}) << "less than the difference is not enough";
}

TEST(Explain, WhatIsTaughtHasANumberForEachParameter) {
  Mouth mouth;
  mouth.problem.taught = {1.0};
  EXPECT_EQ(solve(*mouth.face.rig, mouth.whole, mouth.problem, {}, mouth.work).error().place, "taught");
  mouth.problem.taught.assign(3, std::nan(""));
  EXPECT_EQ(solve(*mouth.face.rig, mouth.whole, mouth.problem, {}, mouth.work).error().place, "taught");
}

}  // namespace
}  // namespace penpose::intent
