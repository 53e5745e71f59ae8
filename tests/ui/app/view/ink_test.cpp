#include "ui/app/view/ink.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace penpose::app {
namespace {

/// A straight line of 300 px with a tremor of some px about it, a wave of which is 36 px long.
std::vector<PxPoint> trembling(double by) {
  std::vector<PxPoint> line;
  for (int i = 0; i <= 150; ++i) line.push_back({100 + 2.0 * i, 200 + by * std::sin(0.35 * i)});
  return line;
}

double roughness(const std::vector<PxPoint>& line) {
  double most = 0;
  // The ends stay where the pen was.
  for (const PxPoint& p : line) {
    if (p.x > 160 && p.x < 340) most = std::max(most, std::abs(p.y - 200));
  }
  return most;
}

TEST(Ink, AStrongerStabiliserShowsASmootherLine) {
  const auto line = trembling(2);
  const std::vector<double> pressed(line.size(), 0.5);
  const auto shown = [&](Stabiliser stabiliser) { return roughness(ink_line(line, pressed, {stabiliser}).points); };
  EXPECT_GT(shown(Stabiliser::off), 1.5);
  // What a Gaussian leaves of a wave: exp(-(2 pi s / l)^2 / 2), s of 6 and 16 px.
  EXPECT_NEAR(shown(Stabiliser::light), 0.58 * 2, 0.1);
  EXPECT_NEAR(shown(Stabiliser::strong), 0.02 * 2, 0.1);
}

TEST(Ink, ALineBeginsAndEndsWhereThePenDid) {
  const auto line = trembling(3);
  for (const Stabiliser one : {Stabiliser::off, Stabiliser::light, Stabiliser::strong}) {
    const auto ink = ink_line(line, std::vector<double>(line.size(), 0.5), {one});
    EXPECT_EQ(ink.points.front(), line.front());
    EXPECT_EQ(ink.points.back(), line.back());
    EXPECT_EQ(ink.points.size(), ink.widths_px.size());
  }
}

TEST(Ink, TheWidthFollowsThePressureAndEndsArePointed) {
  const auto line = trembling(0);
  std::vector<double> pressed(line.size());
  for (std::size_t i = 0; i < line.size(); ++i) pressed[i] = i < line.size() / 2 ? 0.1 : 0.9;
  const auto ink = ink_line(line, pressed, {Stabiliser::light, 1, 2, 7, true});
  const std::size_t n = ink.widths_px.size();
  EXPECT_NEAR(ink.widths_px[n / 4], 2.5, 0.1) << "2 px and a tenth of 5";
  EXPECT_NEAR(ink.widths_px[3 * n / 4], 6.5, 0.1);
  EXPECT_LT(ink.widths_px.back(), 0.5 * ink.widths_px[3 * n / 4]);
  EXPECT_LT(ink.widths_px.front(), 0.5 * ink.widths_px[n / 4]);
  // While the pen goes on, the line is not pointed where it is.
  const auto going_on = ink_line(line, pressed, {Stabiliser::light, 1, 2, 7, false});
  EXPECT_NEAR(going_on.widths_px.back(), 6.5, 0.1);
  // No width jumps, so that no step is seen: at most by the slope of the tip, 0.65 pi / 2 of 6.5 px over 18 px.
  for (std::size_t i = 1; i < n; ++i) EXPECT_LT(std::abs(ink.widths_px[i] - ink.widths_px[i - 1]), 0.75F) << i;
}

TEST(Ink, ADotAndNothingAreShownToo) {
  EXPECT_TRUE(ink_line({}, {}, {}).points.empty());
  const auto dot = ink_line(std::vector<PxPoint>{{5, 5}}, std::vector<double>{1}, {});
  ASSERT_EQ(dot.points.size(), 1U);
  EXPECT_GT(dot.widths_px.front(), 0);
  const auto still = ink_line(std::vector<PxPoint>{{5, 5}, {5, 5}, {5, 5}}, std::vector<double>{1, 1, 1}, {});
  for (const PxPoint& p : still.points) EXPECT_EQ(p, (PxPoint{5, 5}));
}

}  // namespace
}  // namespace penpose::app
