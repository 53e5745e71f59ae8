#include <cmath>
#include <gtest/gtest.h>

#include "core/intent/solve.h"
#include "tests/core/intent/face.h"

// Lines that are drawn one after the other.

namespace penpose::intent {
namespace {

using tests::Face;
using tests::Line;

/// The problem of two lines, of which the first was solved for.
IntentProblem second_of_two(const Face& face, DrawnCurve first, DrawnCurve second, const rig::Pose& posed) {
  first.before = true;
  IntentProblem problem = face.problem({std::move(first), std::move(second)});
  problem.posed = posed;
  return problem;
}

TEST(Posed, ABrowDrawnAfterASmileLeavesTheSmile) {
  const Face face = tests::smiling_face(true);
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    // Its middle is drawn lower than any control brings it: it is read for its shape.
    Line line = face.seen(Face::mouth(), face.pose({{"smile", 0.8}}));
    for (auto& p : line) p.y += 37;
    const DrawnCurve mouth = face.drawn(Face::mouth(), tests::shaken(line, 1, seed));
    const rig::Pose smile = face.solve(face.problem({mouth})).pose;
    const DrawnCurve brow = face.drawn(
        Face::left_brow(), tests::shaken(face.seen(Face::left_brow(), face.pose({{"browLeft", 0.7}})), 1, seed + 50));
    const rig::Pose both = face.solve(second_of_two(face, mouth, brow, smile)).pose;
    for (const char* name : {"smile", "cornerLeft", "cornerRight", "lipUp"})
      EXPECT_NEAR(both[face.number(name)], smile[face.number(name)], 0.03) << name << " " << seed;
    EXPECT_NEAR(both[face.number("browLeft")], 0.7, 0.12) << seed;
    EXPECT_EQ(both[face.number("browRight")], 0) << seed;
  }
}

TEST(Posed, WhatASecondLineTellsOfTheFirstIsHeard) {
  // Of two lines at once both corners are told to move by the smile, where the first was taken for the corner alone.
  const Face face = tests::smiling_face(true);
  const rig::Pose smile = face.pose({{"smile", 0.9}});
  const tests::Points left = Face::row(12, 12, 19);
  const tests::Points right = Face::row(12, 21, 28);
  const DrawnCurve first = face.drawn(left, face.seen(left, smile));
  const DrawnCurve second = face.drawn(right, face.seen(right, smile));
  const rig::Pose wrong = face.pose({{"cornerLeft", 0.5}, {"lipUp", 0.1}});
  const rig::Pose told = face.solve(second_of_two(face, first, second, wrong)).pose;
  EXPECT_LT(face.error(told, smile), 0.1);
  EXPECT_EQ(told[face.number("cornerLeft")], 0);
}

TEST(Posed, IsWithinTheRanges) {
  const Face face = tests::smiling_face(true);
  const DrawnCurve mouth = face.drawn(Face::mouth(), face.seen(Face::mouth(), face.pose({{"smile", 0.5}})));
  IntentProblem problem = face.problem({mouth});
  problem.posed = problem.start;
  problem.posed[0] = 7;
  EXPECT_FALSE(check_problem(*face.rig, problem).ok());
  problem.posed.pop_back();
  EXPECT_FALSE(check_problem(*face.rig, problem).ok());
}

}  // namespace
}  // namespace penpose::intent
