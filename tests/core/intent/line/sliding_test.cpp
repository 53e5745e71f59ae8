#include "core/intent/line/sliding.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/curve/polyline.h"
#include "tests/core/intent/face.h"

namespace penpose::intent {
namespace {

using tests::Line;

/// A bow of 400 px and some, evenly sampled.
Line bow(double height = 80, std::size_t count = 25) {
  Line line;
  for (std::size_t i = 0; i < 100; ++i) {
    const double t = static_cast<double>(i) / 99;
    line.push_back({200 + 400 * t, 500 - 4 * height * t * (1 - t)});
  }
  return curve::resample<PxPoint>(line, count).value();
}

/// Mean distance of the targets from where the points belong.
double off(const Matching& m, const Line& wanted) {
  double sum = 0;
  double weight = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    sum += m.weight[i] * geometry::distance(m.target[i], wanted[i]);
    weight += m.weight[i];
  }
  return sum / weight;
}

/// How far each target lies along a line that runs to the right.
void expect_in_order(const Matching& m, bool reversed) {
  for (std::size_t i = 0; i + 1 < m.target.size(); ++i) {
    if (reversed) {
      EXPECT_LT(m.target[i + 1].x, m.target[i].x) << i;
    } else {
      EXPECT_GT(m.target[i + 1].x, m.target[i].x) << i;
    }
  }
}

TEST(SlidingLine, WithoutSlidingPointsGoToTheSameShareOfTheLength) {
  const Line seen = bow();
  const Line line = bow(120, 77);
  const Matching m = SlidingLine(line).match(seen, {}, false, 2);
  const Line equal = curve::resample<PxPoint>(line, seen.size()).value();
  EXPECT_LT(off(m, equal), 0.5);
  EXPECT_NEAR(m.target.front().x, line.front().x, 1e-9);
  EXPECT_NEAR(m.target.back().x, line.back().x, 1e-9);
  double sum = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    EXPECT_NEAR(dot(m.tangent[i], m.tangent[i]), 1, 1e-9);
    EXPECT_EQ(m.slid[i], 0);
    sum += m.weight[i];
  }
  EXPECT_NEAR(sum, 1, 1e-9) << "points stand for the whole reference";
}

TEST(SlidingLine, ALineDrawnBackwardsIsMetBackwards) {
  const Line seen = bow();
  Alignment reversed;
  reversed.reversed = true;
  EXPECT_LT(off(SlidingLine(tests::backwards(bow(80, 60))).match(seen, reversed, false, 2), seen), 0.5);
  EXPECT_LT(off(SlidingLine(tests::backwards(bow(80, 60))).match(seen, reversed, true, 2), seen), 0.5);
}

TEST(SlidingLine, WhatALineLeavesOutOrOvershootsALittleIsNoWish) {
  const Line seen = bow();
  for (const auto& [from, to] :
       std::vector<std::pair<double, double>>{{0.06, 1}, {0, 0.93}, {-0.07, 1}, {0.05, 1.06}}) {
    const Line line = tests::part(bow(80, 200), from, to);
    const double fixed = off(SlidingLine(line).match(seen, {}, false, 2), seen);
    const double slid = off(SlidingLine(line).match(seen, {}, true, 2), seen);
    EXPECT_GT(fixed, 8) << from << " " << to;
    EXPECT_LT(slid, 0.15 * fixed) << from << " " << to;
  }
}

TEST(SlidingLine, AnUnevenReferenceSlidesToWhereItFits) {
  // The curve stretched in the middle of the model: equal arc length would ask for a change along the line.
  const Line even = bow(80, 200);
  std::vector<double> shares;
  for (std::size_t i = 0; i <= 24; ++i) {
    const double t = static_cast<double>(i) / 24;
    shares.push_back(t + 0.03 * std::sin(3.14159265 * t));
  }
  const Line wanted = curve::resample_at<PxPoint>(even, shares).value();
  Line seen = wanted;
  const SlidingLine line(even);
  EXPECT_LT(off(line.match(seen, {}, true, 2), wanted), 1);
}

TEST(SlidingLine, TheOrderAlongTheLineStays) {
  tests::Random random(3);
  for (int run = 0; run < 100; ++run) {
    Line seen = bow(random(-100, 100));
    for (PxPoint& p : seen) p = p + PxPoint{random(-60, 60), random(-60, 60)};
    Alignment alignment;
    alignment.reversed = run % 2 == 1;
    // Straight, so that the order can be read from x.
    const Line line{{180, 500}, {400, 490}, {620, 505}};
    expect_in_order(SlidingLine(line).match(seen, alignment, true, random(0.3, 5)), alignment.reversed);
  }
}

TEST(SlidingLine, PointsStayOnTheLineOrStraightOnBeyondItsEnds) {
  const Line seen = bow();
  const Line line = tests::shaken(bow(60), 4, 5);
  const Matching m = SlidingLine(line).match(seen, {}, true, 2);
  const Line fine = tests::part(line, -0.2, 1.2, 8000);
  for (const PxPoint& target : m.target) {
    double near = 1e9;
    for (const PxPoint& p : fine) near = std::min(near, geometry::distance(p, target));
    if (target.x < line.front().x || target.x > line.back().x) continue;
    EXPECT_LT(near, 0.2);
  }
}

TEST(SlidingLine, OnlyTheAlignedPartOfTheReferenceIsAskedFor) {
  const Line seen = bow();
  Alignment half;
  half.reference_to = 0.5;
  const Line line = tests::part(bow(80, 200), 0, 0.5);
  const Matching m = SlidingLine(line).match(seen, half, false, 2);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    EXPECT_EQ(m.weight[i] > 0, i <= 12) << i;
    if (i <= 12) {
      EXPECT_LT(geometry::distance(m.target[i], seen[i]), 1.0) << i;
    }
  }
}

TEST(SlidingLine, ALoopIsMetFromWhereverItWasBegun) {
  const auto circle = [](double from, double sense, std::size_t count) {
    Line line;
    for (std::size_t i = 0; i <= count; ++i) {
      const double a = from + sense * 6.283185307 * static_cast<double>(i) / static_cast<double>(count);
      line.push_back({500 + 100 * std::cos(a), 500 + 70 * std::sin(a)});
    }
    return line;
  };
  const Line seen = circle(0, 1, 24);
  for (const double from : {0.0, 1.0, 2.5, 4.0}) {
    for (const double sense : {1.0, -1.0}) {
      const Line line = circle(from, sense, 90);
      const auto list = alignments(seen, line, 8);
      ASSERT_EQ(list.size(), 1U);
      EXPECT_TRUE(list[0].closed);
      EXPECT_LT(off(SlidingLine(line).match(seen, list[0], true, 2), seen), 4.0) << from << " " << sense;
    }
  }
}

TEST(Alignments, EndsAndDirectionTogetherTellWhichWayALineRuns) {
  const Line seen = bow();
  const auto first = [&](const Line& line) { return alignments(seen, line, 8).front(); };
  EXPECT_FALSE(first(bow(100, 50)).reversed);
  EXPECT_TRUE(first(tests::backwards(bow(100, 50))).reversed);
  // Moved a long way to the right: its beginning lies nearest to the reference's end, and yet it runs along with it.
  Line moved = bow();
  for (PxPoint& p : moved) p.x += 300;
  EXPECT_FALSE(first(moved).reversed);
  EXPECT_TRUE(first(tests::backwards(moved)).reversed);
  // The right corner drawn outwards: a short stroke by the end.
  EXPECT_FALSE(first(Line{{540, 490}, {620, 470}}).reversed);
  EXPECT_TRUE(first(Line{{620, 470}, {540, 490}}).reversed);
}

TEST(Alignments, ALineAcrossTheReferenceIsTriedBothWays) {
  const Line seen{{200, 500}, {600, 500}};
  const auto list = alignments(seen, Line{{400, 310}, {400, 690}}, 8);
  ASSERT_GE(list.size(), 2U);
  EXPECT_NE(list[0].reversed, list[1].reversed);
  EXPECT_GT(list[1].charge, list[0].charge);
  EXPECT_EQ(alignments(bow(), bow(), 8).size(), 2U) << "nothing else but a shape beside is worth trying";
}

TEST(Alignments, AShortLineMayBeAPartAndALongOneOvershoots) {
  const Line seen = bow();
  const auto parts = alignments(seen, tests::part(bow(80, 200), 0.5, 1), 8);
  ASSERT_EQ(parts.size(), 5U);
  EXPECT_EQ(parts[0].reference_to - parts[0].reference_from, 1) << "all of it is the likeliest";
  EXPECT_NEAR(parts[1].reference_to, 0.5, 0.01);
  EXPECT_NEAR(parts[2].reference_from, 0.25, 0.01);
  EXPECT_NEAR(parts[3].reference_from, 0.5, 0.01);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_GT(parts[i].charge, parts[0].charge);
  const auto longer = alignments(seen, tests::part(bow(80, 200), 0, 1.25), 8);
  ASSERT_EQ(longer.size(), 5U);
  EXPECT_NEAR(longer[1].line_to - longer[1].line_from, 0.8, 0.01);
}

TEST(Alignments, KnowLinesThatLieBesideWhereTheyWereMeant) {
  const auto list = alignments(bow(), bow(), 8);
  ASSERT_EQ(list.size(), 2U);
  EXPECT_GT(list.front().ends, 0);
  EXPECT_EQ(list.front().offset_px, 0);
  EXPECT_GT(list.back().offset_px, 0);
  EXPECT_GT(list.back().charge, 0);

  // A line that lies beside as a whole costs only by how far: every point may go across by the same way.
  const Line seen = bow();
  const SlidingLine line(seen);
  const Matching m = line.match(seen, list.back(), true, 2);
  ASSERT_EQ(m.across.size(), seen.size());
  EXPECT_NEAR(m.across[seen.size() / 2], list.back().offset_px, 0.01 * list.back().offset_px);
  EXPECT_TRUE(line.match(seen, list.front(), true, 2).across.empty());
}

TEST(Alignments, AllTooMuchAtOneEndIsLessLikelyThanAtBoth) {
  const Line seen = bow();
  Line longer = bow();
  for (auto& p : longer) p = {500 + (p.x - 500) * 1.6, 500 + (p.y - 500) * 1.6};
  double one_end = 1e9, both = 1e9;
  for (const Alignment& one : alignments(seen, longer, 8)) {
    if (one.line_to - one.line_from > 0.99) continue;
    const bool at_one = one.line_from < 1e-9 || one.line_to > 1 - 1e-9;
    (at_one ? one_end : both) = std::min(at_one ? one_end : both, one.charge);
  }
  EXPECT_EQ(both, inference::learned_weights().by[inference::Term::overshot]);
  EXPECT_GT(one_end, 30);
}

TEST(Alignments, OfWhatHasNoLengthIsTheWhole) {
  EXPECT_EQ(alignments(Line{{5, 5}, {5, 5}}, bow(), 8).front().reference_to, 1.0);
}

}  // namespace
}  // namespace penpose::intent
