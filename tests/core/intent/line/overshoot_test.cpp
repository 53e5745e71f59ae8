#include "core/intent/line/overshoot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>

#include "core/curve/polyline.h"
#include "tests/core/intent/face.h"

namespace penpose::intent {
namespace {

using tests::Line;

constexpr double k_doubt = 2;

/// A mouth of 200 px that runs to the right.
Line mouth() { return curve::resample<PxPoint>(Line{{400, 500}, {600, 500}}, 21).value(); }

std::array<Overshoot, 2> of(const Line& line, Alignment alignment = {}) {
  const Line seen = mouth();
  const SlidingLine drawn(line);
  return overshoots(drawn, seen, alignment, drawn.match(seen, alignment, false, k_doubt), k_doubt);
}

/// The part in the middle is the mouth's, a tenth to either side lies beyond.
Alignment with_ends_over() {
  Alignment alignment;
  alignment.line_from = 1.0 / 12;
  alignment.line_to = 11.0 / 12;
  return alignment;
}

TEST(Overshoot, WhatGoesStraightOnTellsNothing) {
  for (const Overshoot& one : of({{380, 501}, {500, 500}, {620, 499}}, with_ends_over())) EXPECT_EQ(one.share, 0);
  for (const Overshoot& one : of({{400, 500}, {600, 500}})) EXPECT_EQ(one.share, 0) << "nothing lies beyond";
}

TEST(Overshoot, EndsThatBendAwayAreSeenWithTheirShareAndPlace) {
  Line line{{400, 460}, {400, 500}, {600, 500}, {600, 460}};
  Alignment alignment;
  alignment.line_from = 40.0 / 280;
  alignment.line_to = 240.0 / 280;
  const auto ends = of(line, alignment);
  for (const Overshoot& one : ends) {
    EXPECT_NEAR(one.share, 0.2, 1e-9);
    EXPECT_NEAR(one.middle.y, 480, 1e-9);
    EXPECT_NEAR(std::abs(one.across.y), 1, 1e-9);
    EXPECT_NEAR(one.spread, 125, 1e-6) << "of four places evenly along 40 px";
  }
  EXPECT_NEAR(ends[0].middle.x, 400, 1e-9);
  EXPECT_NEAR(ends[1].middle.x, 600, 1e-9);
  EXPECT_EQ(ends[0].end, 0U);
  EXPECT_EQ(ends[1].end, 20U);

  std::reverse(line.begin(), line.end());
  alignment.reversed = true;
  const auto turned = of(line, alignment);
  EXPECT_NEAR(turned[0].middle.x, 400, 1e-9) << "drawn the other way round it is the same";
  EXPECT_NEAR(turned[1].middle.x, 600, 1e-9);
}

TEST(Overshoot, OfAReferenceDrawnInPartTheOtherEndLiesElsewhere) {
  Alignment alignment;
  alignment.line_from = 40.0 / 240;
  alignment.reference_to = 0.5;
  const auto ends = of({{400, 460}, {400, 500}, {600, 500}}, alignment);
  EXPECT_GT(ends[0].share, 0);
  EXPECT_EQ(ends[1].share, 0);
}

}  // namespace
}  // namespace penpose::intent
