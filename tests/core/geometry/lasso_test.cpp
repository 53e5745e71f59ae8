#include "core/geometry/lasso.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace penpose::geometry {
namespace {

Lasso lasso(std::vector<PxPoint> curve) { return Lasso::make(curve).value(); }

TEST(Lasso, JoinsItsEnds) {
  const Lasso square = lasso({{0, 0}, {10, 0}, {10, 10}, {0, 10}});  // the left side is not drawn
  EXPECT_TRUE(square.contains({1, 5}));
  EXPECT_FALSE(square.contains({-1, 5}));
  EXPECT_DOUBLE_EQ(square.distance({1, 5}), 1.0);
  EXPECT_DOUBLE_EQ(square.distance({-3, 14}), 5.0);
}

TEST(Lasso, FollowsTheEvenOddRule) {
  // A pentagram: its middle is crossed around twice.
  std::vector<PxPoint> star;
  for (int i = 0; i < 5; ++i) star.push_back({std::sin(i * 2.513274) * 10, -std::cos(i * 2.513274) * 10});
  EXPECT_FALSE(lasso(star).contains({0, 0}));
  EXPECT_TRUE(lasso(star).contains({0, -8}));
}

TEST(Lasso, CountsARayThroughACornerOnce) {
  const Lasso diamond = lasso({{0, -10}, {10, 0}, {0, 10}, {-10, 0}});
  EXPECT_TRUE(diamond.contains({0, 0}));
  EXPECT_FALSE(diamond.contains({-20, 0}));
  EXPECT_FALSE(diamond.contains({-20, -10}));
  EXPECT_FALSE(diamond.contains({20, 0}));
}

TEST(Lasso, AgreesWithTheSlowWayOnLongCurves) {
  std::mt19937_64 random(7);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  std::vector<PxPoint> curve;
  for (int i = 0; i < 333; ++i) {
    const double turn = 6.283185307 * i / 333;
    const double reach = 80 + 60 * std::sin(5 * turn) + 10 * uniform();
    curve.push_back({100 + std::cos(turn) * reach, 100 + std::sin(turn) * reach});
  }
  const Lasso fast = lasso(curve);
  for (int trial = 0; trial < 2000; ++trial) {
    const PxPoint p{uniform() * 260 - 30, uniform() * 260 - 30};
    bool inside = false;
    double nearest = 1e300;
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const PxPoint a = curve[i];
      const PxPoint b = curve[(i + 1) % curve.size()];
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y))) inside = !inside;
      const PxPoint ab = b - a;
      const double t =
          std::fmin(1, std::fmax(0, ((p.x - a.x) * ab.x + (p.y - a.y) * ab.y) / (ab.x * ab.x + ab.y * ab.y)));
      nearest = std::fmin(nearest, distance(p, a + ab * t));
    }
    EXPECT_EQ(fast.contains(p), inside);
    EXPECT_NEAR(fast.distance(p), nearest, 1e-9);
  }
}

TEST(Lasso, RefusesWhatEnclosesNothing) {
  EXPECT_FALSE(Lasso::make({}).ok());
  EXPECT_FALSE(Lasso::make(std::vector<PxPoint>{{1, 1}, {2, 2}, {1, 1}, {1, 1}}).ok());
  EXPECT_FALSE(Lasso::make(std::vector<PxPoint>{{1, 1}, {2, 2}, {std::nan(""), 1}}).ok());
  EXPECT_FALSE(Lasso::make(std::vector<PxPoint>{{1, 1}, {2, 2}, {1e300, 1}}).ok());
}

}  // namespace
}  // namespace penpose::geometry
