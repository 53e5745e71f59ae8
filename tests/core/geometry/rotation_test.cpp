#include "core/geometry/rotation.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include "core/base/math.h"
#include "tests/support/random.h"

namespace penpose::geometry {
namespace {

constexpr double k_quarter = base::k_pi / 2;

double worst_difference(const glm::dmat3& a, const glm::dmat3& b) {
  double worst = 0;
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) worst = std::max(worst, std::abs(a[c][r] - b[c][r]));
  }
  return worst;
}

/// Rotation about a coordinate axis, written out.
glm::dmat3 about(int axis, double angle) {
  const int i = (axis + 1) % 3;
  const int j = (axis + 2) % 3;
  glm::dmat3 m(0);
  m[axis][axis] = 1;
  m[i][i] = m[j][j] = std::cos(angle);
  m[i][j] = std::sin(angle);
  m[j][i] = -std::sin(angle);
  return m;
}

TEST(Rotation, TurnsCounterClockwiseAboutItsAxis) {
  const auto turned = [](const ModelVector& axis, const ModelVector& v) { return rotation_about(axis, k_quarter) * v; };
  EXPECT_NEAR(distance(turned({0, 0, 1}, {1, 0, 0}), {0, 1, 0}), 0, 1e-15);
  EXPECT_NEAR(distance(turned({1, 0, 0}, {0, 1, 0}), {0, 0, 1}), 0, 1e-15);
  EXPECT_NEAR(distance(turned({0, 1, 0}, {0, 0, 1}), {1, 0, 0}), 0, 1e-15);
  for (int axis = 0; axis < 3; ++axis) {
    ModelVector unit{0};
    unit[axis] = 1;
    EXPECT_LT(worst_difference(rotation_about(unit, 0.7), about(axis, 0.7)), 1e-15);
  }
}

TEST(Rotation, IsRigid) {
  tests::Random random(11);
  for (int i = 0; i < 200; ++i) {
    const glm::dmat3 r = rotation_about(normalized(random.vector()), random(-7, 7));
    EXPECT_LT(worst_difference(glm::transpose(r) * r, glm::dmat3(1)), 1e-14);
    EXPECT_NEAR(glm::determinant(r), 1, 1e-14);
  }
}

TEST(TurnBetween, TakesOneDirectionToTheOther) {
  tests::Random random(11);
  for (int i = 0; i < 500; ++i) {
    const ModelVector from = random.vector(5);
    const ModelVector to = i % 5 == 0 ? from * -2.0 : random.vector(0.1);
    const Turn turn = turn_between(from, to);
    EXPECT_GE(turn.angle, 0);
    EXPECT_LE(turn.angle, base::k_pi);
    EXPECT_NEAR(length(turn.axis), 1, 1e-12);
    EXPECT_NEAR(distance(rotation_about(turn.axis, turn.angle) * normalized(from), normalized(to)), 0, 1e-9);
    EXPECT_NEAR(glm::dot(turn.axis, normalized(from)), 0, 1e-9) << "the shortest way turns about a perpendicular axis";
  }
}

TEST(TurnBetween, GivesNoTurnWhereThereIsNone) {
  EXPECT_EQ(turn_between({1, 2, 3}, {2, 4, 6}).angle, 0);
  EXPECT_EQ(turn_between({0, 0, 0}, {1, 0, 0}).angle, 0);
  EXPECT_EQ(turn_between({1, 0, 0}, {0, 0, 0}).angle, 0);
  EXPECT_EQ(turn_between({1, 0, 0}, {-1, 0, 0}).axis, turn_between({1, 0, 0}, {-1, 0, 0}).axis);
}

TEST(Quaternion, TurnsAboutXThenTheTurnedYThenTheTurnedZ) {
  tests::Random random(11);
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 angles = random.vector(3);
    const glm::dmat3 expected = about(0, angles.x) * about(1, angles.y) * about(2, angles.z);
    const glm::dmat3 got(compose({0, 0, 0}, quaternion_from_xyz(angles), {1, 1, 1}));
    EXPECT_LT(worst_difference(got, expected), 1e-14);
  }
}

TEST(Quaternion, AnglesComeBack) {
  tests::Random random(11);
  for (int i = 0; i < 500; ++i) {
    const glm::dvec3 angles{random(-3.1, 3.1), random(-1.5, 1.5), random(-3.1, 3.1)};
    EXPECT_NEAR(length(xyz_from_quaternion(quaternion_from_xyz(angles)) - angles), 0, 1e-9);
  }
}

TEST(Quaternion, AnglesDescribeTheSameTurnWhereTwoAxesMeet) {
  for (const double y : {k_quarter, -k_quarter, k_quarter - 1e-7, 1e-7 - k_quarter}) {
    for (const double x : {0.0, 0.4, -2.0}) {
      for (const double z : {0.0, 0.9, -1.3}) {
        const glm::dquat q = quaternion_from_xyz({x, y, z});
        const glm::dvec3 angles = xyz_from_quaternion(q);
        EXPECT_LE(std::abs(angles.y), k_quarter);
        const glm::dmat3 again(compose({0, 0, 0}, quaternion_from_xyz(angles), {1, 1, 1}));
        EXPECT_LT(worst_difference(again, glm::dmat3(compose({0, 0, 0}, q, {1, 1, 1}))), 1e-6);
      }
    }
  }
}

TEST(Compose, ScalesThenTurnsThenMoves) {
  const glm::dquat quarter_about_z(std::sqrt(0.5), 0, 0, std::sqrt(0.5));
  const glm::dmat4 m = compose({10, 20, 30}, quarter_about_z, {2, 3, 4});
  // (1, 1, 1) scales to (2, 3, 4), turns to (-3, 2, 4) and moves.
  EXPECT_NEAR(distance(ModelPoint(m * glm::dvec4(1, 1, 1, 1)), {7, 22, 34}), 0, 1e-14);
}

TEST(Compose, NormalisesItsQuaternion) {
  const glm::dquat q(0.5, 0.1, -0.3, 0.7);
  EXPECT_LT(worst_difference(glm::dmat3(compose({0, 0, 0}, q * 3.0, {1, 1, 1})),
                             glm::dmat3(compose({0, 0, 0}, q, {1, 1, 1}))),
            1e-15);
  EXPECT_EQ(compose({0, 0, 0}, glm::dquat(0, 0, 0, 0), {1, 1, 1}), glm::dmat4(1));
}

}  // namespace
}  // namespace penpose::geometry
