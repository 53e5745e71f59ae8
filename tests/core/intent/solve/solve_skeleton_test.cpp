// Strokes along limbs: a chain of joints along x, 0.4 apart, from the middle of the sheet to the right.
#include <gtest/gtest.h>

#include "core/intent/solve.h"
#include "tests/core/intent/face.h"

namespace penpose::intent {
namespace {

using tests::Face;
using tests::Line;
using tests::Points;

struct Limb {
  Face face;
  Points row = Face::row(20, 28, 40);  // x = 0.4 to 1: carried by joints 1 and 2
  Limb() { face.ready(tests::chain_skeleton(*face.mesh, 3, 0.4)); }
  static std::size_t about(std::size_t joint, std::size_t axis) { return 3 * joint + axis; }
  [[nodiscard]] Solution solve(const Line& line) const { return face.solve(face.problem({face.drawn(row, line)})); }
};

TEST(IntentSkeleton, ALimbDrawnTurnedTurnsAndJointsOutsideTheChainStay) {
  const Limb limb;
  for (const double angle : {-0.9, -0.5, 0.3, 0.7, 1.2}) {
    rig::Pose answer = rig::rest_pose(*limb.face.rig);
    answer[Limb::about(1, 2)] = angle;
    const Solution solution = limb.solve(limb.face.seen(limb.row, answer));
    EXPECT_LT(limb.face.error(solution.pose, answer), 0.15) << angle;
    for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_EQ(solution.pose[Limb::about(0, axis)], 0) << angle;
    EXPECT_FALSE(solution.linear);
  }
}

TEST(IntentSkeleton, ALimbRedrawnWhereItIsStays) {
  const Limb limb;
  const rig::Pose rest = rig::rest_pose(*limb.face.rig);
  for (std::uint64_t seed = 0; seed < 5; ++seed)
    EXPECT_EQ(limb.solve(tests::shaken(limb.face.seen(limb.row, rest), 1, seed)).pose, rest) << seed;
}

TEST(IntentSkeleton, NoTwistThatWasNotDrawn) {
  const Limb limb;
  rig::Pose answer = rig::rest_pose(*limb.face.rig);
  answer[Limb::about(1, 2)] = 0.6;
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Solution solution = limb.solve(tests::shaken(limb.face.seen(limb.row, answer), 1.5, seed));
    for (std::size_t joint = 1; joint < 3; ++joint)
      EXPECT_LT(std::abs(solution.pose[Limb::about(joint, 0)]), 0.05) << seed << " " << joint;
  }
}

TEST(IntentSkeleton, JointsKeepTheirLimits) {
  Limb limb;
  Line line = limb.face.seen(limb.row, rig::rest_pose(*limb.face.rig));
  for (PxPoint& p : line) p = {1000 - p.x, 900};
  const Solution solution = limb.solve(line);
  for (std::size_t p = 0; p < solution.pose.size(); ++p) {
    EXPECT_GE(solution.pose[p], limb.face.rig->parameters()[p].minimum);
    EXPECT_LE(solution.pose[p], limb.face.rig->parameters()[p].maximum);
  }
}

TEST(IntentSkeleton, WhatTheChainCannotReachMovesTheJointsBeforeIt) {
  // The whole limb lower by 0.3: only the joint at its root takes it there.
  const Limb limb;
  rig::Pose answer = rig::rest_pose(*limb.face.rig);
  answer[Limb::about(0, 2)] = -0.7;
  const Solution solution = limb.solve(limb.face.seen(limb.row, answer));
  EXPECT_LT(solution.pose[Limb::about(0, 2)], -0.4);
  EXPECT_LT(solution.drawn[0].px, 15);
}

}  // namespace
}  // namespace penpose::intent
