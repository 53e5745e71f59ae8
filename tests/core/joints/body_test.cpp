#include "core/joints/body.h"

#include <gtest/gtest.h>

#include "tests/support/models/stick_figure.h"

namespace penpose::joints {
namespace {

using tests::StickFigure;

TEST(JointPlaces, AreWhereTheFigureWasBuilt) {
  const StickFigure man = tests::stick_man();
  const auto skeleton = man.skeleton();
  const auto places = places_of(*skeleton, std::vector<double>(skeleton->parameters().size(), 0.0));
  EXPECT_LT(geometry::distance(places[7].at, {0.42, 1.40, 0}), 1e-12);
  EXPECT_GT(std::abs(glm::dot(places[7].turn, man.frame(7))), 1 - 1e-12);
}

TEST(JointPlaces, TurnWithTheirParents) {
  const StickFigure man = tests::stick_man();
  const auto skeleton = man.skeleton();
  std::vector<double> values(skeleton->parameters().size(), 0.0);
  const glm::dvec3 angles = man.angles(6, {0, 0, 1}, 0.8);
  for (int k = 0; k < 3; ++k) values[18 + static_cast<std::size_t>(k)] = angles[k];
  const auto places = places_of(*skeleton, values);
  const geometry::ModelPoint elbow =
      geometry::ModelPoint{0.15, 1.45, 0} + geometry::rotation_about({0, 0, 1}, 0.8) * glm::dvec3{0.27, -0.05, 0};
  EXPECT_LT(geometry::distance(places[7].at, elbow), 1e-12);
}

TEST(Body, BonesPointToWhatHangsOnThem) {
  const Body body(*tests::stick_man().skeleton());
  EXPECT_GT(glm::dot(body.bone(1, {}), {0, 1, 0}), 0.999);
  EXPECT_GT(body.bone(6, {}).x, 0.95);
  EXPECT_GT(body.bone(8, {}).x, 0.9) << "a last joint goes on as its parent's bone does";
  const std::vector<std::size_t> arm{4, 6, 7};
  EXPECT_GT(body.bone(4, arm).x, 0.8) << "where a chain parts the bone is the chain's";
  EXPECT_GT(body.bone(4, {}).y, -0.1) << "and else between all branches";
}

TEST(Body, KneesAndElbowsShowTheirHinge) {
  const Body body(*tests::stick_man().skeleton());
  const auto knee = body.hinge(10);
  ASSERT_TRUE(knee);
  EXPECT_GT(std::abs(knee->axis.x), 0.999) << "bent in the plane of the legs";
  EXPECT_NEAR(knee->bent, 2 * std::atan(0.03 / 0.4), 0.01);
  // Turning about it bends the knee further: the shin goes backwards.
  EXPECT_LT((geometry::rotation_about(knee->axis, 0.5) * glm::dvec3{0, -1, 0}).z, -0.4);
  EXPECT_TRUE(body.hinge(7));
}

TEST(Body, StraightLimbsSpinesAndFirstJointsShowNone) {
  const Body body(*tests::stick_man().skeleton());
  for (const std::size_t joint : {0U, 1U, 2U, 3U, 4U, 5U, 6U, 9U, 11U}) EXPECT_FALSE(body.hinge(joint)) << joint;
  StickFigure tail;
  geometry::ModelPoint at{0};
  for (int k = 0; k < 9; ++k) {
    const geometry::ModelPoint next = at + geometry::ModelVector{std::cos(0.2 * k), std::sin(0.2 * k), 0};
    tail.add(k - 1, at, next);
    at = next;
  }
  const Body curled(*tail.skeleton());
  for (std::size_t joint = 0; joint < 9; ++joint) EXPECT_FALSE(curled.hinge(joint)) << "a tail is curled, not bent";
}

TEST(Body, JointsThatSpreadATwistAreHelpers) {
  StickFigure man = tests::stick_man();
  const std::size_t helper = man.add_helper(6, 0.6);
  const Body body(*man.skeleton());
  EXPECT_TRUE(body.helper(helper));
  EXPECT_EQ(body.meant(helper), 6U);
  EXPECT_EQ(body.branches(6).size(), 1U) << "the forearm alone";
  for (std::size_t joint = 0; joint < helper; ++joint) EXPECT_FALSE(body.helper(joint)) << joint;
}

TEST(Body, NoHelperWithoutABoneThatGoesOn) {
  // A head between two eyes, and a lonely joint.
  StickFigure head;
  head.add(-1, {0, 0, 0}, {0, 1, 0});
  head.add(0, {0.3, 0.8, 0}, {0.3, 0.8, 0.2});
  head.add(0, {-0.3, 0.8, 0}, {-0.3, 0.8, 0.2});
  const Body body(*head.skeleton());
  EXPECT_FALSE(body.helper(1));
  EXPECT_FALSE(body.helper(2));
}

}  // namespace
}  // namespace penpose::joints
