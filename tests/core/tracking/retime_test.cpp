#include "core/tracking/retime.h"

#include <gtest/gtest.h>

#include "core/base/math.h"

namespace penpose::tracking {
namespace {

animation::WeightTrack take(std::vector<std::string> names, std::vector<std::vector<double>> rows, double step_s) {
  animation::WeightTrack track;
  track.names = std::move(names);
  for (std::size_t f = 0; f < rows.size(); ++f)
    track.frames.push_back({static_cast<double>(f) * step_s, !rows[f].empty(), rows[f]});
  return track;
}

TEST(Retime, ResampledFramesLieBetweenThoseOfTheTake) {
  auto track = take({"jawOpen"}, {{0}, {1}, {0}}, 0.5);
  ASSERT_TRUE(resample(track, 4));
  ASSERT_EQ(track.frames.size(), 5U);
  const double values[] = {0, 0.5, 1, 0.5, 0};
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_DOUBLE_EQ(track.frames[k].time_s, 0.25 * static_cast<double>(k));
    EXPECT_DOUBLE_EQ(track.frames[k].values[0], values[k]) << k;
  }
  auto lost = take({"jawOpen"}, {{0}, {}, {1}}, 0.5);
  ASSERT_TRUE(resample(lost, 4));
  EXPECT_FALSE(lost.frames[2].found) << "a frame without a face stays one";
  auto long_one = take({"jawOpen"}, {{0}, {1}}, 1e6);
  EXPECT_EQ(resample(long_one, 10000).error().place, "fps");
}

TEST(Retime, PointsGoEvenlyBetweenTwoFrames) {
  animation::PointTrack track;
  track.point_count = 1;
  track.frames = {{0, 1, {{0, 0}}, {}}, {1, 0.5, {{10, 20}}, {}}};
  ASSERT_TRUE(resample(track, 2));
  ASSERT_EQ(track.frames.size(), 3U);
  EXPECT_EQ(track.frames[1].points[0], (geometry::PxPoint{5, 10}));
  EXPECT_DOUBLE_EQ(track.frames[1].confidence, 0.5);
}

TEST(Retime, PercentIsDividedAndSharesAreNot) {
  auto percent = take({"JawOpen", "MouthSmileLeft", "TongueOut", "HeadYaw"}, {{50, 80, 0, 0.2}, {10, 99, 0, 0.4}}, 1);
  EXPECT_TRUE(divide_percent(percent));
  EXPECT_DOUBLE_EQ(percent.frames[0].values[0], 0.5);
  EXPECT_DOUBLE_EQ(percent.frames[1].values[1], 0.99);
  EXPECT_DOUBLE_EQ(percent.frames[1].values[3], 0.4) << "a turn is none";
  auto shares = take({"JawOpen", "MouthSmileLeft"}, {{0.5, 1.2}, {1.05, 0.1}}, 1);
  EXPECT_FALSE(divide_percent(shares));
  auto bytes = take({"JawOpen", "MouthSmileLeft"}, {{255, 30}, {80, 120}}, 1);
  EXPECT_FALSE(divide_percent(bytes));
}

/// A head that turns by so much to one side within a second, 30 frames a second, and back.
animation::WeightTrack turning(double most) {
  animation::WeightTrack track;
  track.names = {"HeadYaw", "jawOpen"};
  for (int f = 0; f <= 60; ++f) track.frames.push_back({f / 30.0, true, {most * (f < 30 ? f : 60 - f) / 30.0, 5}});
  return track;
}

TEST(Retime, DegreesOfAHeadAreToldFromRadians) {
  for (const double degrees : {20.0, 3.0, 90.0}) {
    auto track = turning(degrees);
    const bool tell = degrees != 3;
    EXPECT_EQ(take_degrees(track), tell) << degrees;
    EXPECT_NEAR(track.frames[30].values[0], tell ? base::radians(degrees) : degrees, 1e-12);
    EXPECT_EQ(track.frames[30].values[1], 5) << "no turn";
  }
  auto radians = turning(1.2);
  EXPECT_FALSE(take_degrees(radians));
  // Within half a turn, but no head shakes so fast.
  auto shakes = turning(0);
  for (int f = 0; f <= 60; ++f) shakes.frames[static_cast<std::size_t>(f)].values[0] = f % 4 < 2 ? 2.5 : -1.25;
  EXPECT_TRUE(take_degrees(shakes));
}

TEST(Retime, TheNeutralFrameIsSubtractedDownToZero) {
  auto track = take({"JawOpen", "HeadYaw"}, {{0.3, 0.1}, {0.8, -0.2}, {0.1, 0.1}}, 1);
  ASSERT_TRUE(subtract_neutral(track, 0));
  EXPECT_DOUBLE_EQ(track.frames[1].values[0], 0.5);
  EXPECT_DOUBLE_EQ(track.frames[2].values[0], 0);
  EXPECT_NEAR(track.frames[1].values[1], -0.3, 1e-12);
  EXPECT_FALSE(subtract_neutral(track, 3));
}

}  // namespace
}  // namespace penpose::tracking
