#include "core/document/drawing/target_line.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>

namespace penpose::document {
namespace {

using curve::PxPoint;
using geometry::ModelPoint;

View front() { return {{{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 30}, {1000, 1000}}; }

PxPoint seen(const ModelPoint& p) { return *geometry::Camera::make(front().camera, {1000, 1000}).value().project(p); }

std::vector<ModelPoint> reference() {
  std::vector<ModelPoint> points;
  for (int i = 0; i < 9; ++i) points.emplace_back(-1 + 0.25 * i, 0, 0.5);
  return points;
}

TEST(TargetLine, IsLiftedToTheDepthOfItsReference) {
  const auto target =
      make_target(reference(), front(), std::vector<PxPoint>{seen({-1, 1, 0.5}), seen({1, 1, 0.5})}, {}).value();
  ASSERT_EQ(target.points.size(), 9U);
  ASSERT_EQ(target.line.size(), k_line_points);
  for (std::size_t i = 0; i < 9; ++i) {
    const ModelPoint straight_ahead(-1 + 0.25 * static_cast<double>(i), 1, 0.5);
    EXPECT_NEAR(geometry::distance(seen(target.points[i]), seen(straight_ahead)), 0, 1e-6);
    EXPECT_NEAR(geometry::distance(target.points[i], straight_ahead), 0, 0.06) << "about as far away";
  }
  EXPECT_EQ(target.pressure, std::vector<double>(k_line_points, 1.0));
  EXPECT_EQ(target.weights, std::vector<double>(9, 1.0));
  EXPECT_EQ(target.view, front());
}

TEST(TargetLine, PressureFollowsTheLineWhicheverWayItWasDrawn) {
  const std::vector<PxPoint> line{seen({-1, 1, 0.5}), seen({0, 1, 0.5}), seen({1, 1, 0.5})};
  const std::vector<double> pressure{0, 0.5, 1};
  const auto forward = make_target(reference(), front(), line, pressure).value();
  EXPECT_NEAR(forward.pressure.front(), 0, 1e-12);
  EXPECT_NEAR(forward.pressure.back(), 1, 1e-12);
  EXPECT_NEAR(std::accumulate(forward.weights.begin(), forward.weights.end(), 0.0), 9, 1e-9);
  EXPECT_NEAR(forward.weights[4], 1, 1e-6);
  EXPECT_NEAR(forward.weights[8], 2, 1e-6);
  const auto backward = make_target(reference(), front(), std::vector<PxPoint>(line.rbegin(), line.rend()),
                                    std::vector<double>(pressure.rbegin(), pressure.rend()))
                            .value();
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_NEAR(backward.weights[i], forward.weights[i], 1e-9) << i;
    EXPECT_NEAR(geometry::distance(backward.points[i], forward.points[i]), 0, 1e-9) << i;
  }
  EXPECT_NEAR(backward.pressure.front(), 1, 1e-12) << "the line itself is kept as it was drawn";
}

TEST(TargetLine, NoPressureAtAllPullsEvenly) {
  const std::vector<PxPoint> line{seen({-1, 1, 0.5}), seen({1, 1, 0.5})};
  EXPECT_EQ(make_target(reference(), front(), line, std::vector<double>{0, 0}).value().weights,
            std::vector<double>(9, 1.0));
}

TEST(TargetLine, RefusesWhatHasNoLength) {
  const std::vector<PxPoint> line{seen({-1, 1, 0.5}), seen({1, 1, 0.5})};
  EXPECT_EQ(make_target(reference(), front(), line, std::vector<double>{1}).error().place, "pressure");
  EXPECT_FALSE(make_target(reference(), front(), std::vector<PxPoint>{line[0]}, {}).ok());
  EXPECT_FALSE(make_target(reference(), front(), std::vector<PxPoint>{line[0], line[0]}, {}).ok());
  View wrong = front();
  wrong.viewport.height = 0;
  EXPECT_FALSE(make_target(reference(), wrong, line, {}).ok());
}

TEST(ComeNear, LinesThatCrossTouchOrPass) {
  const std::vector<PxPoint> line{{0, 0}, {100, 0}, {200, 0}};
  EXPECT_TRUE(come_near(line, std::vector<PxPoint>{{150, -50}, {150, 50}}, 0));
  EXPECT_TRUE(come_near(line, std::vector<PxPoint>{{210, 50}, {210, 9}}, 15)) << "past the end";
  EXPECT_FALSE(come_near(line, std::vector<PxPoint>{{210, 50}, {210, 9}}, 13));
  EXPECT_TRUE(come_near(line, std::vector<PxPoint>{{50, 10}}, 10)) << "a tap";
  EXPECT_FALSE(come_near(line, std::vector<PxPoint>{{50, 10.5}}, 10));
  EXPECT_TRUE(come_near(std::vector<PxPoint>{{50, 10}}, std::vector<PxPoint>{{50, 12}}, 2)) << "a tap on a pin";
  EXPECT_FALSE(come_near({}, line, 1000));
  EXPECT_FALSE(come_near(line, {}, 1000));
}

}  // namespace
}  // namespace penpose::document
