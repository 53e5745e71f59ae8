#include "core/portrait/sheet_warp.h"

#include <gtest/gtest.h>

namespace penpose::portrait {
namespace {

std::vector<PxPoint> grid() {
  std::vector<PxPoint> out;
  for (int x = -2; x <= 2; ++x) {
    for (int y = -2; y <= 2; ++y) out.push_back({100.0 * x, 120.0 * y});
  }
  return out;
}

TEST(SheetWarp, AnAffineMapIsReproducedEverywhereForItDoesNotBend) {
  const auto from = grid();
  std::vector<PxPoint> to;
  for (const PxPoint& p : from) to.push_back({1.2 * p.x - 0.1 * p.y + 30.0, 0.05 * p.x + 0.9 * p.y - 12.0});
  const SheetWarp warp(from, to);
  const PxPoint p{37.0, -410.0};
  const PxPoint there = p + warp.offset(p);
  EXPECT_NEAR(there.x, 1.2 * p.x - 0.1 * p.y + 30.0, 1e-6);
  EXPECT_NEAR(there.y, 0.05 * p.x + 0.9 * p.y - 12.0, 1e-6);
  const auto d = warp.derivative(p);
  EXPECT_NEAR(d[0], 1.2, 1e-6);
  EXPECT_NEAR(d[1], -0.1, 1e-6);
  EXPECT_NEAR(d[2], 0.05, 1e-6);
  EXPECT_NEAR(d[3], 0.9, 1e-6);
}

TEST(SheetWarp, APointThatIsPulledComesNearToWhereItIsPulled) {
  const auto from = grid();
  auto to = from;
  to[12] = to[12] + PxPoint{20, 0};
  const SheetWarp warp(from, to);
  EXPECT_GT(warp.offset(from[12]).x, 10.0);
  EXPECT_LT(warp.offset(from[0]).x, 3.0);
}

TEST(SheetWarp, FewerThanThreePointsAndThoseOfOneLineMoveNothing) {
  const std::vector<PxPoint> two{{0, 0}, {10, 0}}, moved{{5, 0}, {15, 0}};
  EXPECT_EQ(SheetWarp(two, moved).offset({3, 3}), (PxPoint{0, 0}));
  const std::vector<PxPoint> line{{0, 0}, {100, 0}, {200, 0}, {300, 0}};
  const PxPoint off = SheetWarp(line, line).offset({30, 40});
  EXPECT_NEAR(off.x, 0.0, 1e-9);
  EXPECT_NEAR(off.y, 0.0, 1e-9);
}

}  // namespace
}  // namespace penpose::portrait
