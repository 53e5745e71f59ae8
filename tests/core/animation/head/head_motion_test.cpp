#include "core/animation/head/head_motion.h"

#include <cmath>
#include <gtest/gtest.h>

namespace penpose::animation {
namespace {

/// Four stable points and one that moves, px.
PointTrack square_track(std::size_t frames) {
  PointTrack track;
  track.point_count = 5;
  for (std::size_t f = 0; f < frames; ++f) {
    TrackFrame frame;
    frame.time_s = static_cast<double>(f) / 30;
    frame.confidence = 1;
    frame.points = {{100, 100}, {200, 100}, {200, 160}, {100, 160}, {150, 220}};
    track.frames.push_back(frame);
  }
  return track;
}

const StablePoints k_corners{{0, 1, 2, 3}, {}};

PxPoint turned(PxPoint p, double angle, double scale, PxPoint shift) {
  const double c = scale * std::cos(angle);
  const double s = scale * std::sin(angle);
  return {c * p.x - s * p.y + shift.x, s * p.x + c * p.y + shift.y};
}

TEST(HeadMotion, ASimilarityLeavesNothing) {
  auto track = square_track(3);
  for (auto& p : track.frames[1].points) p = turned(p, 0.7, 1.3, {40, -20});
  for (auto& p : track.frames[2].points) p = turned(p, -2.5, 0.6, {-300, 900});
  const auto still = take_head_motion_out(track, k_corners, {}, 0).value();
  for (const auto& offsets : still.offsets) {
    for (const PxPoint& o : offsets) {
      EXPECT_NEAR(o.x, 0, 1e-9);
      EXPECT_NEAR(o.y, 0, 1e-9);
    }
  }
  EXPECT_NEAR(still.turns[1].scale, 1.3, 1e-12);
  EXPECT_NEAR(still.turns[1].rotation[0][1], std::sin(0.7), 1e-12);
}

TEST(HeadMotion, WhatMovesOnTheFaceIsSeenUpright) {
  auto track = square_track(2);
  track.frames[1].points[4] = {150, 230};
  for (auto& p : track.frames[1].points) p = turned(p, 1.2, 2.0, {5, 6});
  const auto still = take_head_motion_out(track, k_corners, {}, 0).value();
  EXPECT_NEAR(still.offsets[1][4].x, 0, 1e-9);
  EXPECT_NEAR(still.offsets[1][4].y, 10, 1e-9);
  EXPECT_NEAR(still.offsets[1][0].y, 0, 1e-9);
}

TEST(HeadMotion, ANodIsToldFromAPulledMouthWhereDepthsAreKnown) {
  // Seen from afar: the nose (2, 3) stands out, the mouth (4) a little.
  const std::vector<double> depths{0, 0, 60, 50, 30};
  auto track = square_track(2);
  for (auto& frame : track.frames) frame.depths = depths;
  const double angle = 0.4;
  for (std::size_t i = 0; i < 5; ++i) {
    PxPoint& p = track.frames[1].points[i];
    p.y = std::cos(angle) * p.y + std::sin(angle) * depths[i];
  }
  const auto still = take_head_motion_out(track, k_corners, {}, 0).value();
  EXPECT_NEAR(still.offsets[1][4].y, 0, 0.05);
  EXPECT_NEAR(std::acos(still.turns[1].rotation[2][2]), angle, 0.01);
  EXPECT_GT(still.doubt[1], 0.5);
  EXPECT_LT(still.doubt[0], 1e-6);
  const double lid = std::abs(take_head_motion_out(track, {{0, 1, 2, 3}, {}, {4}}, {}, 0).value().offsets[1][4].y);
  // The same picture without depths is taken for a pulled mouth.
  for (auto& frame : track.frames) frame.depths.clear();
  const double pulled = std::abs(take_head_motion_out(track, k_corners, {}, 0).value().offsets[1][4].y);
  EXPECT_GT(pulled, 3);
  // Of lids half of the nod is taken out: they may have closed as well.
  EXPECT_GT(lid, 0.2 * pulled);
  EXPECT_LT(lid, 0.8 * pulled);
}

TEST(HeadMotion, FramesWithoutAFaceRepeatTheTurn) {
  auto track = square_track(4);
  for (auto& p : track.frames[1].points) p = p + PxPoint{10, 0};
  track.frames[2].confidence = 0;
  track.frames[2].points.clear();
  track.frames[3].confidence = 0.1;
  const auto still = take_head_motion_out(track, k_corners, {}, 0.2).value();
  EXPECT_TRUE(still.offsets[2].empty());
  EXPECT_TRUE(still.offsets[3].empty());
  EXPECT_EQ(still.confidence[3], 0);
  EXPECT_NEAR(still.turns[2].shift.x, 10, 1e-9);
}

TEST(HeadMotion, StartsAtTheFirstFaceOrAtTheFrameThatWasNamed) {
  auto track = square_track(4);
  track.frames[0].confidence = 0;
  EXPECT_EQ(take_head_motion_out(track, k_corners, {}, 0).value().neutral, 1U);
  EXPECT_EQ(take_head_motion_out(track, k_corners, 3, 0).value().neutral, 3U);
  EXPECT_FALSE(take_head_motion_out(track, k_corners, 0, 0).ok());
  EXPECT_FALSE(take_head_motion_out(track, k_corners, 99, 0).ok());
  for (auto& frame : track.frames) frame.confidence = 0;
  EXPECT_FALSE(take_head_motion_out(track, k_corners, {}, 0).ok());
}

TEST(HeadMotion, RefusesStablePointsThatTellNothing) {
  auto track = square_track(2);
  EXPECT_EQ(take_head_motion_out(track, {{0, 9}, {}}, {}, 0).error().place, "/stable");
  EXPECT_EQ(take_head_motion_out(track, {{0, 1}, {7}}, {}, 0).error().place, "/turning");
  track.frames[0].points[1] = track.frames[0].points[0];
  // The first frame in which they lie apart is taken, but not in place of one that was asked for.
  EXPECT_EQ(take_head_motion_out(track, {{0, 1}, {}}, {}, 0).value().neutral, 1U);
  EXPECT_EQ(take_head_motion_out(track, {{0, 1}, {}}, 0, 0).error().place, "/stable");
  track.frames[1].points[1] = track.frames[1].points[0];
  EXPECT_FALSE(take_head_motion_out(track, {{0, 1}, {}}, {}, 0).ok());
  track.frames[1].points[1] = {200, 100};
  // None at all: the head counts as still.
  const auto still = take_head_motion_out(track, {}, {}, 0).value();
  EXPECT_EQ(still.turns[1].scale, 1);
  EXPECT_NEAR(still.offsets[1][1].x, 100, 1e-12);
}

glm::dmat3 nod(double angle) {
  return {1, 0, 0, 0, std::cos(angle), std::sin(angle), 0, -std::sin(angle), std::cos(angle)};
}

/// Points of a nodding head seen from afar, with another one far behind the others; a smile draws the nose (2) down.
PointTrack smiling_nod(double angle) {
  auto track = square_track(2);
  const std::vector<double> depths{0, 0, 60, 50, -150};
  for (auto& frame : track.frames) frame.depths = depths;
  for (std::size_t i = 0; i < 5; ++i) {
    PxPoint& p = track.frames[1].points[i];
    p.y = std::cos(angle) * p.y + std::sin(angle) * depths[i];
  }
  track.frames[1].points[2].y += 12;
  return track;
}

double nod_of(const StillTrack& still) {
  return std::atan2(-still.turns[1].rotation[2][1], still.turns[1].rotation[2][2]);
}

TEST(HeadMotion, PointsFarBehindTellANodFromASmileThatDrawsTheNoseDown) {
  const auto track = smiling_nod(0.2);
  const auto near = take_head_motion_out(track, k_corners, {}, 0).value();
  const auto far = take_head_motion_out(track, {{0, 1, 2, 3}, {4}}, {}, 0).value();
  EXPECT_LT(std::abs(nod_of(far) - 0.2), 0.5 * std::abs(nod_of(near) - 0.2));
  // What moved on the face is measured by the stable points alone.
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(far.offsets[1][i], near.offsets[1][i]);
}

TEST(HeadMotion, TheTrackersOwnTurnStandsWhereItAgreesWithThePoints) {
  auto track = smiling_nod(0.2);
  track.frames[0].rotation = nod(0.1);
  track.frames[1].rotation = nod(0.31);
  EXPECT_NEAR(nod_of(take_head_motion_out(track, k_corners, {}, 0).value()), 0.21, 1e-12);
  // Columns of another unit or other axes, or that are always the same, are not believed.
  const double own = nod_of(take_head_motion_out(smiling_nod(0.2), k_corners, {}, 0).value());
  track.frames[1].rotation = nod(1.4);
  EXPECT_NEAR(nod_of(take_head_motion_out(track, k_corners, {}, 0).value()), own, 1e-12);
  track.frames[1].rotation = track.frames[0].rotation;
  EXPECT_NEAR(nod_of(take_head_motion_out(track, k_corners, {}, 0).value()), own, 1e-12);
}

}  // namespace
}  // namespace penpose::animation
