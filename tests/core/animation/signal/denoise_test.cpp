#include "core/animation/signal/denoise.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "tests/support/models/rendered_track.h"

namespace penpose::animation {
namespace {

StillTrack one_curve(const std::vector<double>& y, double shake = 0) {
  StillTrack track;
  tests::Shaker random;
  for (const double value : y) {
    track.confidence.push_back(1);
    std::vector<PxPoint>& points = track.offsets.emplace_back();
    for (int i = 0; i < 5; ++i) {
      const double dx = shake * random();
      points.push_back({dx, value + shake * random()});
    }
  }
  return track;
}

const std::vector<std::size_t> k_all{0, 1, 2, 3, 4};

double roughness(const StillTrack& track) {
  double sum = 0;
  for (std::size_t f = 1; f < track.offsets.size(); ++f) {
    sum += std::abs(track.offsets[f][2].y - track.offsets[f - 1][2].y);
  }
  return sum / static_cast<double>(track.offsets.size() - 1);
}

TEST(Denoise, TakesTremorAway) {
  auto track = one_curve(std::vector<double>(100, 0.0), 1);
  const double before = roughness(track);
  denoise(track, k_all, 1);
  EXPECT_LT(roughness(track), before / 3);
}

TEST(Denoise, KeepsABlinkSharpAndOnTime) {
  std::vector<double> y(40, 0.0);
  y[19] = y[21] = 8;
  y[20] = 14;
  auto track = one_curve(y);
  denoise(track, k_all, 1);
  EXPECT_NEAR(track.offsets[20][2].y, 14, 0.2);
  EXPECT_NEAR(track.offsets[19][2].y, 8, 0.7);  // less than the tremor
  EXPECT_NEAR(track.offsets[17][2].y, 0, 0.2);
}

TEST(Denoise, DoesNotLagBehindASteadyMovement) {
  std::vector<double> y;
  for (int f = 0; f < 40; ++f) y.push_back(0.3 * f);
  auto track = one_curve(y);
  denoise(track, k_all, 1);
  for (std::size_t f = 6; f < 34; ++f) EXPECT_NEAR(track.offsets[f][0].y, y[f], 1e-9);
}

TEST(Denoise, PassesOverFramesWithoutAFace) {
  auto track = one_curve(std::vector<double>(10, 3.0));
  track.offsets[4].clear();
  track.confidence[4] = 0;
  denoise(track, k_all, 1);
  EXPECT_TRUE(track.offsets[4].empty());
  EXPECT_NEAR(track.offsets[5][0].y, 3, 1e-12);
}

TEST(Denoise, TwoMovementsAtDifferentTimesLeaveEachOtherAlone) {
  // Points 0 and 1 rise by 6 px in the frames 20 to 26, points 3 and 4 go aside by 6 px in the frames 45 to 51; all
  // shake by a px.
  StillTrack track;
  StillTrack calm;
  tests::Shaker random;
  const auto ramp = [](int f, int start) { return static_cast<double>(std::clamp(f - start, 0, 6)); };
  for (int f = 0; f < 80; ++f) {
    calm.confidence.push_back(1);
    calm.offsets.push_back({{0, ramp(f, 20)}, {0, ramp(f, 20)}, {}, {ramp(f, 45), 0}, {ramp(f, 45), 0}});
  }
  track = calm;
  for (auto& offsets : track.offsets) {
    for (PxPoint& p : offsets) p = p + PxPoint{random(), random()};
  }
  const StillTrack shaken = track;
  denoise(track, k_all, 1);
  double before = 0;
  double after = 0;
  for (std::size_t f = 0; f < 80; ++f) {
    for (std::size_t i = 0; i < 5; ++i) {
      before += geometry::distance(shaken.offsets[f][i], calm.offsets[f][i]);
      after += geometry::distance(track.offsets[f][i], calm.offsets[f][i]);
    }
  }
  EXPECT_LT(after, before / 2.5);
  EXPECT_NEAR(track.offsets[70][3].x - track.offsets[10][3].x, 6, 0.5);
  EXPECT_NEAR(track.offsets[70][3].y, 0, 0.3);  // not drawn along by the others
  EXPECT_LT(roughness(track), 0.03);            // point 2 takes part in neither
}

TEST(Denoise, TakesACurveOfAThousandPointsToo) {
  StillTrack track;
  tests::Shaker random;
  std::vector<std::size_t> points(1000);
  for (std::size_t i = 0; i < 1000; ++i) points[i] = i;
  for (int f = 0; f < 30; ++f) {
    track.confidence.push_back(1);
    std::vector<PxPoint>& offsets = track.offsets.emplace_back();
    for (std::size_t i = 0; i < 1000; ++i) {
      const double dx = random();
      offsets.push_back({dx, 0.5 * f + random()});
    }
  }
  denoise(track, points, 1);
  for (const std::size_t i : {0U, 500U, 999U}) EXPECT_NEAR(track.offsets[15][i].y, 7.5, 0.5) << i;
  EXPECT_LT(std::abs(track.offsets[15][999].x), 0.5);
}

TEST(MeasureFrom, TakesHalfOfWhatTheNeutralFrameWasOffOutOfAllOthers) {
  auto track = one_curve({1, 1, 1, 5});
  track.offsets[2].clear();
  measure_from(track, 0);
  EXPECT_NEAR(track.offsets[1][0].y, 0.5, 1e-12);
  EXPECT_NEAR(track.offsets[3][4].y - track.offsets[1][4].y, 4, 1e-12);  // what moves between frames stays
  EXPECT_TRUE(track.offsets[2].empty());
}

TEST(DenoiseParameters, KeepsLargeMovementsAndLevelsSmallOnes) {
  std::vector<std::vector<double>> rows;
  const std::vector<double> confidence(40, 1.0);
  for (int f = 0; f < 40; ++f)
    rows.push_back({(f < 20 ? 0.0 : 0.8) + (f % 2 == 0 ? 0.02 : -0.02), f % 2 == 0 ? 0.02 : -0.02});
  denoise_parameters(std::vector<double>{0.03, 0}, confidence, rows);
  EXPECT_LT(std::abs(rows[10][0] - rows[11][0]), 0.01);
  EXPECT_GT(rows[20][0] - rows[19][0], 0.6);
  EXPECT_NEAR(rows[17][0], 0, 0.03);
  EXPECT_NEAR(rows[22][0], 0.8, 0.03);
  EXPECT_NEAR(rows[10][1], 0.02, 1e-12);  // left alone
}

TEST(RoundCorners, ASmallMovementThatStartsAFrameEarlyIsNoJumpAndABlinkKeepsItsPeak) {
  // The same ramp of 0.06 a frame with its corner in frame 20 and in frame 21, the same blink in the second column.
  std::vector<std::vector<double>> early;
  std::vector<std::vector<double>> late;
  for (int f = 0; f < 40; ++f) {
    const double blink = std::max(0.0, 1.0 - 0.25 * std::abs(f - 20));
    early.push_back({0.06 * std::clamp(f - 20, 0, 6), blink, 0.01 * f});
    late.push_back({0.06 * std::clamp(f - 21, 0, 6), blink, 0.01 * f});
  }
  const auto line = early;
  const std::vector<double> sharp{0.2, 0.2, 0.2};
  round_corners(sharp, early);
  round_corners(sharp, late);
  double largest = 0;
  for (std::size_t f = 1; f < 40; ++f) {
    const double steps = (early[f][0] - early[f - 1][0]) - (late[f][0] - late[f - 1][0]);
    largest = std::max(largest, std::abs(steps));
  }
  EXPECT_LT(largest, 0.02);  // 0.06 as it was
  EXPECT_GT(early[20][1], 0.95);
  for (std::size_t f = 10; f < 30; ++f) EXPECT_NEAR(early[f][2], line[f][2], 1e-9);  // a steady movement stays
}

TEST(SmoothOverTime, IsSymmetricAndKeepsStraightLines) {
  std::vector<double> times;
  std::vector<std::vector<double>> rows;
  for (int f = 0; f < 30; ++f) {
    times.push_back(f / 30.0);
    rows.push_back({f == 15 ? 1.0 : 0.0, 0.1 * f});
  }
  smooth_over_time(times, 0.1, rows);
  EXPECT_LT(rows[15][0], 0.5);
  EXPECT_GT(rows[15][0], rows[14][0]);
  EXPECT_NEAR(rows[14][0], rows[16][0], 1e-12);
  for (std::size_t f = 0; f < 30; ++f) EXPECT_NEAR(rows[f][1], 0.1 * static_cast<double>(f), 1e-9);
}

}  // namespace
}  // namespace penpose::animation
