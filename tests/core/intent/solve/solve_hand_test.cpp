// What a hand does to a line that was meant: backwards, uneven, too short, too long, unsteady.
#include <gtest/gtest.h>

#include "core/intent/solve.h"
#include "tests/core/intent/face.h"

namespace penpose::intent {
namespace {

using tests::Face;
using tests::Line;

struct Smile {
  Face face = tests::usual_face();
  rig::Pose answer = face.pose({{"cornerLeft", 0.7}, {"cornerRight", 0.7}});
  Line line = tests::part(face.seen(Face::mouth(), answer), 0, 1, 200);

  [[nodiscard]] Solution solve(const Line& drawn) const {
    return face.solve(face.problem({face.drawn(Face::mouth(), drawn)}));
  }
  [[nodiscard]] double error(const Line& drawn) const { return face.error(solve(drawn).pose, answer); }
};

TEST(IntentHand, AnExactLineIsNotMadeWorseBySliding) {
  const Smile s;
  EXPECT_LT(s.error(s.line), 0.03);
  EXPECT_LT(s.solve(s.line).drawn[0].px, 0.5);
}

TEST(IntentHand, ALineDrawnBackwardsMeansTheSame) {
  const Smile s;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const Line line = tests::shaken(s.line, 2, seed);
    const Solution one = s.solve(line);
    const Solution other = s.solve(tests::backwards(line));
    EXPECT_FALSE(one.drawn[0].reversed);
    EXPECT_TRUE(other.drawn[0].reversed);
    EXPECT_EQ(one.moved, other.moved);
    for (std::size_t p = 0; p < one.pose.size(); ++p) EXPECT_NEAR(one.pose[p], other.pose[p], 0.02) << p;
  }
}

TEST(IntentHand, HowFastThePenRanIsNoWish) {
  const Smile s;
  // The same line by few and unevenly spaced reports.
  std::vector<double> shares;
  for (int i = 0; i <= 30; ++i) shares.push_back((i / 30.0) * (i / 30.0));
  const Line slow_start = curve::resample_at<PxPoint>(s.line, shares).value();
  EXPECT_LT(s.error(slow_start), 0.05);
}

TEST(IntentHand, ALineOfAPartOfTheLengthMeansTheSamePose) {
  const Smile s;
  for (const double left_out : {0.03, 0.06, 0.1}) {
    EXPECT_LT(s.error(tests::part(s.line, left_out, 1)), 0.15) << left_out;
    EXPECT_LT(s.error(tests::part(s.line, 0, 1 - left_out)), 0.15) << left_out;
    EXPECT_LT(s.error(tests::part(s.line, left_out / 2, 1 - left_out / 2)), 0.15) << left_out;
  }
}

TEST(IntentHand, AHalfOrAThirdOfTheLineMovesTheSideThatWasDrawn) {
  const Smile s;
  const std::size_t left = s.face.number("cornerLeft");
  for (const double share : {0.3, 0.4, 0.5, 0.6}) {
    const Solution solution = s.solve(tests::part(s.line, 0, share));
    EXPECT_NEAR(solution.pose[left], 0.7, 0.15) << share;
    for (const char* other : {"jawOpen", "jawLeft", "jawRight", "swell"})
      EXPECT_EQ(solution.pose[s.face.number(other)], 0) << share << " " << other;
  }
}

TEST(IntentHand, ALineOvershotByAFifthMeansTheSamePose) {
  const Smile s;
  EXPECT_LT(s.error(tests::part(s.line, 0, 1.2)), 0.2);
  EXPECT_LT(s.error(tests::part(s.line, -0.2, 1)), 0.2);
  EXPECT_LT(s.error(tests::part(s.line, -0.1, 1.1)), 0.2);
}

TEST(IntentHand, TremorChangesThePoseByLittle) {
  const Smile s;
  for (const double px : {1.0, 2.0, 4.0}) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      const Line line = tests::shaken(s.line, px, seed);
      const Solution solution = s.solve(line);
      EXPECT_LT(s.face.error(solution.pose, s.answer), 0.06 * (1 + px)) << px << " " << seed;
      EXPECT_LE(solution.moved.size(), 3U);
    }
  }
}

TEST(IntentHand, AWiderDoubtBelievesLessOfTheLine) {
  const Smile s;
  const Line line = s.face.seen(Face::mouth(), s.face.pose({{"cornerLeft", 0.2}}));
  DrawnCurve careful = s.face.drawn(Face::mouth(), line);
  DrawnCurve rough = careful;
  careful.doubt_px = 0.5;
  rough.doubt_px = 20;
  EXPECT_EQ(s.face.solve(s.face.problem({careful})).moved.size(), 1U);
  EXPECT_TRUE(s.face.solve(s.face.problem({rough})).moved.empty());
}

TEST(IntentHand, PointsDrawnWithoutPressureAskForNothing) {
  const Smile s;
  // The line lifts the right corner as well; its half weighs nothing.
  DrawnCurve curve = s.face.drawn(Face::mouth(), s.line);
  curve.weights.assign(17, 0.0);
  for (std::size_t i = 0; i < 8; ++i) curve.weights[i] = 17.0 / 8;
  const rig::Pose pose = s.face.solve(s.face.problem({curve})).pose;
  EXPECT_NEAR(pose[s.face.number("cornerLeft")], 0.7, 0.1);
  EXPECT_EQ(pose[s.face.number("cornerRight")], 0);
}

}  // namespace
}  // namespace penpose::intent
