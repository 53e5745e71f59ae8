#include "core/portrait/contour/contour_match.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace penpose::portrait {
namespace {

SeenContour contour_of(std::vector<PxPoint> px) {
  SeenContour out;
  for (std::size_t i = 0; i < px.size(); ++i) {
    out.lengths.push_back(i == 0 ? 0.0 : out.lengths.back() + geometry::distance(px[i - 1], px[i]));
    if (i + 1 == px.size()) break;
    if (i % k_boxed == 0) out.boxes.emplace_back();
    out.boxes.back().add(px[i]);
    out.boxes.back().add(px[i + 1]);
  }
  out.px = std::move(px);
  return out;
}

/// A finger: up on one side, 12 px to the right, and down on the other.
std::vector<SeenContour> finger() {
  std::vector<PxPoint> px;
  for (int y = 400; y >= 100; y -= 10) px.push_back({300, static_cast<double>(y)});
  for (int y = 100; y <= 400; y += 10) px.push_back({312, static_cast<double>(y)});
  return {contour_of(std::move(px))};
}

TEST(ContourMatch, TellsBothSidesOfWhatIsThinByDirectionAndOrder) {
  const auto contours = finger();
  EvenLine line{{}, 6};
  // Along the right side, drawn 5 px to the left of it: nearer to the left side at its end.
  for (int i = 0; i < 40; ++i) line.points.push_back({307.0 - 0.05 * i, 120.0 + 6.0 * i});
  const ContourMatch match = match_contour(line, contours);
  std::optional<ContourPlace> before;
  for (const auto& place : match.places) {
    ASSERT_TRUE(place);
    EXPECT_EQ(place->px.x, 312);
    if (before) {
      EXPECT_GE(place->segment, before->segment);
    }
    before = place;
  }
  // Drawn from its other end it is the same line.
  EvenLine back = line;
  std::reverse(back.points.begin(), back.points.end());
  const ContourMatch other = match_contour(back, contours);
  EXPECT_DOUBLE_EQ(other.doubt, match.doubt);
  for (std::size_t i = 0; i < match.places.size(); ++i)
    EXPECT_EQ(other.places[match.places.size() - 1 - i]->px, match.places[i]->px);
}

TEST(ContourMatch, WhatIsFarOrAcrossIsNoContour) {
  const auto contours = finger();
  EvenLine far{{}, 6}, across{{}, 6};
  for (int i = 0; i < 20; ++i) {
    far.points.push_back({600, 100.0 + 6.0 * i});
    across.points.push_back({250.0 + 6.0 * i, 250});
  }
  for (const EvenLine& line : {far, across}) {
    const ContourMatch match = match_contour(line, contours);
    for (const auto& place : match.places) EXPECT_FALSE(place);
    EXPECT_NEAR(match.doubt, 20 * 6 / k_contour_look_px * contour_doubt(90), 1e-9);
  }
}

TEST(ContourMatch, DoubtGrowsWithDistanceAndFarPointsCountLess) {
  EXPECT_EQ(contour_doubt(0), 0.0);
  EXPECT_NEAR(contour_doubt(k_contour_doubt_px), 4 * std::log(1.25), 1e-12);
  EXPECT_LT(contour_weight(30), 0.05);
  EXPECT_EQ(contour_weight(0), 1.0);
}

}  // namespace
}  // namespace penpose::portrait
