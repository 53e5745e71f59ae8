#include "core/portrait/reading/strokes.h"

#include <cmath>
#include <gtest/gtest.h>

namespace penpose::portrait {
namespace {

using Line = std::vector<geometry::PxPoint>;

Line around(double radius) {
  Line line;
  for (int i = 0; i <= 40; ++i)
    line.push_back({radius * std::cos(0.157 * i + 1.0), radius * std::sin(0.157 * i + 1.0)});
  return line;
}

TEST(Strokes, ALineDrawnAroundIsItsUpperAndItsLowerHalf) {
  const std::vector<Line> lines = {around(50), {{0, 0}, {10, 5}, {20, 0}}};
  const auto strokes = strokes_of(lines, {});
  ASSERT_EQ(strokes.size(), 3U);
  EXPECT_FALSE(strokes[0].lower);
  EXPECT_TRUE(strokes[1].lower);
  EXPECT_LT(strokes[0].points[strokes[0].points.size() / 2].y, -40);
  EXPECT_GT(strokes[1].points[strokes[1].points.size() / 2].y, 40);
  EXPECT_EQ(strokes[1].lines, (std::vector<std::size_t>{0}));
  EXPECT_EQ(strokes[2].points, lines[1]);
}

TEST(Strokes, ALineThatIsSaidToBeSomethingStaysWhole) {
  const std::vector<Line> lines = {around(50)};
  const std::vector<std::optional<std::size_t>> given = {3};
  EXPECT_EQ(strokes_of(lines, given).size(), 1U);
}

}  // namespace
}  // namespace penpose::portrait
