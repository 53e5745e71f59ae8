#include <gtest/gtest.h>

#include "core/intent/live.h"
#include "core/intent/solve.h"
#include "tests/core/intent/face.h"

// "Not this one": what becomes of a stroke whose meaning the artist has locked.

namespace penpose::intent {
namespace {

using tests::Face;
using tests::Line;

IntentProblem with_locked(IntentProblem problem, const std::vector<std::size_t>& locked) {
  for (const std::size_t i : locked) std::erase(problem.free, i);
  problem.locked = locked;
  return problem;
}

TEST(Locked, TheOtherSideOfAPairDoesWhatItWasMeantTo) {
  const Face face = tests::usual_face();
  const std::size_t left = face.number("browLeft"), right = face.number("browRight");
  const rig::Pose answer = face.pose({{"browLeft", 0.7}, {"browRight", 0.7}});
  IntentProblem problem = face.problem({face.drawn(Face::left_brow(), face.seen(Face::left_brow(), answer)),
                                        face.drawn(Face::right_brow(), face.seen(Face::right_brow(), answer))});
  const Solution meant = face.solve(problem);
  const Solution solution = face.solve(with_locked(problem, {std::min(left, right)}));
  const std::size_t held = std::min(left, right), other = std::max(left, right);
  EXPECT_EQ(solution.pose[held], 0);
  EXPECT_EQ(solution.moved, std::vector<std::size_t>{other});
  EXPECT_NEAR(solution.pose[other], meant.pose[other], 0.05);
}

TEST(Locked, NoMoreControlsMoveThanWereMeant) {
  const Face face = tests::usual_face();
  for (const char* name : {"jawOpen", "lipUp", "cornerLeft", "jawLeft"}) {
    const rig::Pose answer = face.pose({{name, 0.8}});
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      const Line line = tests::shaken(face.seen(Face::mouth(), answer), 1.5, seed);
      const IntentProblem problem = face.problem({face.drawn(Face::mouth(), line)});
      const Solution meant = face.solve(problem);
      ASSERT_EQ(meant.moved.size(), 1U);
      const Solution solution = face.solve(with_locked(problem, meant.moved));
      EXPECT_EQ(solution.pose[meant.moved[0]], 0);
      EXPECT_LE(solution.moved.size(), 2U) << name << ": one control or one pair";
      EXPECT_LE(solution.energy, meant.energy_start + 1e-9) << name;
    }
  }
}

TEST(Locked, WhatWasNotMeantMayBeLockedWithoutADifference) {
  const Face face = tests::usual_face();
  const rig::Pose answer = face.pose({{"jawOpen", 0.6}});
  const IntentProblem problem = face.problem({face.drawn(Face::mouth(), face.seen(Face::mouth(), answer))});
  EXPECT_EQ(face.solve(with_locked(problem, {face.number("browLeft")})).pose, face.solve(problem).pose);
}

TEST(Locked, LiveAgreesWithPenUp) {
  const Face face = tests::usual_face();
  const rig::Pose answer = face.pose({{"browLeft", 0.7}, {"browRight", 0.7}});
  const Line line = face.seen(Face::left_brow(), answer);
  const std::size_t left = face.number("browLeft");
  const IntentProblem problem = with_locked(face.problem({face.drawn(Face::left_brow(), line)}), {left});
  auto poser = LivePoser::start(*face.rig, measure_whole_model(*face.rig), problem);
  ASSERT_TRUE(poser.ok());
  for (std::size_t n = 2; n <= line.size(); ++n) poser->follow(std::span(line).first(n));
  EXPECT_EQ(poser->pose()[left], 0);
  std::size_t moved = 0;
  for (const double value : poser->pose()) moved += value != 0 ? 1U : 0U;
  EXPECT_LE(moved, 2U);
}

}  // namespace
}  // namespace penpose::intent
