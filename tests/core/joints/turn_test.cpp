#include "core/joints/turn.h"

#include <gtest/gtest.h>

#include "core/base/math.h"
#include "tests/support/models/stick_figure.h"

namespace penpose::joints {
namespace {

struct Desk {
  tests::StickFigure man = tests::stick_man();
  std::shared_ptr<const rig::Skeleton> skeleton = man.skeleton();
  Body body{*skeleton};

  [[nodiscard]] Turn turn(std::size_t joint, std::optional<ModelVector> ray, glm::dvec3 start = glm::dvec3{0}) const {
    std::vector<double> values(skeleton->parameters().size(), 0.0);
    for (int k = 0; k < 3; ++k) values[3 * joint + static_cast<std::size_t>(k)] = start[k];
    return make_turn(body, skeleton->joints()[joint], joint, 3 * joint, std::span(values).subspan(3 * joint, 3),
                     places_of(*skeleton, values)[joint], {}, ray);
  }
};

const ModelVector k_front{0, 0, -1};

double apart(const glm::dquat& a, const glm::dquat& b) { return 1.0 - std::abs(glm::dot(a, b)); }

TEST(Turn, IsARotationAboutTheJointsOwnAxesFromTheStart) {
  const Desk desk;
  for (const glm::dvec3 start : {glm::dvec3{0}, glm::dvec3{0.4, -0.3, 0.2}}) {
    const Turn turn = desk.turn(6, k_front, start);
    EXPECT_LT(apart(geometry::quaternion_from_xyz(angles_of(turn, glm::dvec3{0})), turn.start), 1e-14);
    const glm::dvec3 w{0.3, -0.2, 0.1};
    const glm::dvec3 own = turn.axes * w;
    const double angle = std::sqrt(glm::dot(own, own));
    const glm::dvec3 v = own * (std::sin(angle / 2) / angle);
    const glm::dquat expected = turn.start * glm::dquat(std::cos(angle / 2), v.x, v.y, v.z);
    EXPECT_LT(apart(geometry::quaternion_from_xyz(angles_of(turn, w)), expected), 1e-12);
  }
}

TEST(Turn, AboutTheViewTurnsTheLimbInThePicture) {
  const Desk desk;
  const Turn turn = desk.turn(6, k_front);
  ASSERT_TRUE(turn.planar);
  const glm::dvec3 angles = angles_of(turn, {0.7, 0, 0});
  std::vector<double> values(desk.skeleton->parameters().size(), 0.0);
  for (int k = 0; k < 3; ++k) values[18 + static_cast<std::size_t>(k)] = angles[k];
  const auto before = desk.body.rest()[7].at - desk.body.rest()[6].at;
  const auto after = places_of(*desk.skeleton, values)[7].at - desk.body.rest()[6].at;
  EXPECT_LT(geometry::distance(after, geometry::rotation_about(k_front, 0.7) * before), 1e-12);
}

TEST(Turn, ABoneThatPointsAtTheEyeDoesNotBendInThePicture) {
  const Desk desk;
  EXPECT_FALSE(desk.turn(6, geometry::normalized(desk.body.bone(6, {}))).planar);
}

TEST(Turn, StaysInTheRangesOfItsParameters) {
  const Desk desk;
  const Turn turn = desk.turn(6, k_front);
  for (const double x : {-3.0, -1.9, 0.4, 1.7, 3.0}) {
    for (const double y : {-2.0, 0.0, 2.5}) {
      const glm::dvec3 angles = angles_of(turn, {x, y, 0.5});
      for (int k = 0; k < 3; ++k) {
        EXPECT_GE(angles[k], turn.minimum[k]);
        EXPECT_LE(angles[k], turn.maximum[k]);
      }
    }
  }
}

TEST(Turn, ATwistCostsWhatABendDoesNot) {
  const Desk desk;
  const Turn turn = desk.turn(6, std::nullopt);
  EXPECT_GT(turn.cost({0, 0, 0.3}), 4.0);
  EXPECT_LT(turn.cost({0.6, 0, 0}), 0.01);
  EXPECT_EQ(turn.cost(glm::dvec3{0}), 0.0);
}

TEST(Turn, AKneeBendsOneWay) {
  const Desk desk;
  const Turn turn = desk.turn(10, std::nullopt);
  EXPECT_LT(turn.cost({1.2, 0, 0}), 0.01) << "backwards";
  EXPECT_GT(turn.cost({-0.8, 0, 0}), 5.0) << "forwards, beyond straight";
  EXPECT_LT(turn.cost({-0.1, 0, 0}), 0.01) << "straight";
  EXPECT_GT(turn.cost({0, 0.8, 0}), 1.0) << "sideways";
  EXPECT_LT(turn.cost({0, 0.8, 0}), 5.0) << "but a hand that draws it so may have it";
}

TEST(Turn, AKneeSeenFromTheFrontBendsInDepth) {
  const Desk desk;
  EXPECT_TRUE(desk.turn(10, k_front).bends_in_depth);
  EXPECT_FALSE(desk.turn(10, ModelVector{-1, 0, 0}).bends_in_depth);
  EXPECT_FALSE(desk.turn(9, k_front).bends_in_depth) << "a hip is no hinge";
}

TEST(Turn, LimitsAreAboutTheRestPoseWhereverItStarts) {
  const Desk desk;
  const Turn rest = desk.turn(6, std::nullopt);
  const glm::dvec3 half = angles_of(rest, {1.0, 0, 0});
  const Turn later = desk.turn(6, std::nullopt, half);
  EXPECT_LT(rest.cost({1.0, 0, 0}), 0.01);
  EXPECT_GT(later.cost({1.0, 0, 0}), 5.0);
  EXPECT_EQ(later.cost(glm::dvec3{0}), 0.0) << "where it starts costs nothing";
}

TEST(Turn, RangesOfTheFileTakeThePlaceOfLimits) {
  tests::StickFigure man = tests::stick_man();
  man.limit(10, {-1.5, -0.5, -0.5}, {1.5, 0.5, 0.5});
  man.limit(7, {-1.5, -0.1, -0.1}, {1.5, 0.1, 0.1});
  const auto skeleton = man.skeleton();
  const Body body(*skeleton);
  EXPECT_TRUE(turns_freely(skeleton->joints()[10]));
  EXPECT_FALSE(turns_freely(skeleton->joints()[7])) << "a hinge by its ranges turns by its angles";
  const std::vector<double> values(skeleton->parameters().size(), 0.0);
  const Turn turn = make_turn(body, skeleton->joints()[10], 10, 30, std::span(values).subspan(30, 3),
                              places_of(*skeleton, values)[10], {}, std::nullopt);
  EXPECT_LT(turn.cost({-0.8, 0, 0}), 0.01);
  EXPECT_LE(std::abs(angles_of(turn, {2, 2, 0}).y), 0.5);
}

}  // namespace
}  // namespace penpose::joints
