#include "core/curve/bend.h"

#include <cmath>
#include <gtest/gtest.h>

namespace penpose::curve {
namespace {

std::vector<PxPoint> straight() {
  std::vector<PxPoint> line;
  for (int i = 0; i <= 100; ++i) line.push_back({100.0 + i, 50});
  return line;
}

TEST(Bend, FollowsByTheFormulaItStates) {
  const auto line = straight();
  const auto weights = pull_weights(line, 40, 0.3, false);
  for (int i = 0; i <= 100; ++i) {
    const double x = std::abs(i - 40) / 30.0;
    const double wanted = x < 1 ? (1 - x * x) * (1 - x * x) : 0;
    EXPECT_NEAR(weights[static_cast<std::size_t>(i)], wanted, 1e-12) << i;
  }
  const auto bent_line = bent(line, {140, 60}, {0, -20}, 0.3, false);
  ASSERT_TRUE(bent_line.has_value());
  EXPECT_NEAR((*bent_line)[40].y, 30, 1e-9) << "the place that is held goes where the pen goes";
  EXPECT_EQ((*bent_line)[5], line[5]) << "what is out of reach stays to the bit";
  EXPECT_EQ((*bent_line)[75], line[75]);
}

TEST(Bend, TakesTheWholeLineWithoutAReach) {
  const auto line = straight();
  const auto moved = bent(line, {100, 50}, {3, 4}, 0, false);
  ASSERT_TRUE(moved.has_value());
  for (std::size_t i = 0; i < line.size(); ++i) EXPECT_EQ((*moved)[i], line[i] + (PxPoint{3, 4}));
}

TEST(Bend, GoesTheShorterWayRoundAClosedLine) {
  std::vector<PxPoint> ring;
  for (int i = 0; i <= 100; ++i) ring.push_back({std::cos(i * 0.0628318531) * 100, std::sin(i * 0.0628318531) * 100});
  const auto weights = pull_weights(ring, 0, 0.2, true);
  EXPECT_NEAR(weights.front(), 1, 1e-12);
  EXPECT_NEAR(weights.back(), 1, 1e-9) << "the end is where the beginning is";
  EXPECT_NEAR(weights[5], weights[95], 1e-9);
  EXPECT_EQ(weights[50], 0);
}

TEST(Bend, GivesACornerLineCornersToBendAt) {
  const std::vector<PxPoint> two{{0, 0}, {100, 0}};
  const auto line = bent(two, {50, 0}, {0, 30}, 0.25, false);
  ASSERT_TRUE(line.has_value());
  EXPECT_GE(line->size(), 32U);
  double most = 0;
  for (const PxPoint& p : *line) most = std::max(most, p.y);
  EXPECT_GT(most, 29);
  EXPECT_EQ(line->front(), two.front());
  EXPECT_EQ(line->back(), two.back());
  EXPECT_FALSE(bent(std::vector<PxPoint>{{5, 5}, {5, 5}}, {5, 5}, {1, 1}, 0.3, false).has_value());
}

}  // namespace
}  // namespace penpose::curve
