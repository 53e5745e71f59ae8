#include "core/portrait/placement.h"

#include <gtest/gtest.h>

namespace penpose::portrait {
namespace {

Trace arc(double x, double y) {
  Trace out{};
  for (std::size_t i = 0; i < k_points; ++i) {
    const double t = static_cast<double>(i);
    out[2 * i] = x + 9.0 * t;
    out[2 * i + 1] = y + t * (11.0 - t);
  }
  return out;
}

TEST(Placement, ASimilarityIsFoundThoughOneLineLiesElsewhere) {
  const Placement meant{1.2, 0.15, {40, -25}};
  std::vector<Match> matches;
  for (const auto& [x, y] : {std::pair{-200.0, 10.0}, {150.0, -90.0}, {20.0, 160.0}})
    matches.push_back({arc(x, y), meant(arc(x, y)), 1.0});
  // A mouth that opened.
  matches.push_back({arc(0, 0), meant(arc(0, 60)), 1.0});
  const Placement found = placed(matches, {});
  EXPECT_NEAR(found.along, meant.along, 0.01);
  EXPECT_NEAR(found.across, meant.across, 0.01);
  EXPECT_NEAR(found.shift.x, meant.shift.x, 2.0);
  EXPECT_NEAR(found.shift.y, meant.shift.y, 2.0);
}

TEST(Placement, NothingToMatchLeavesTheGuess) {
  const Placement guess{0.8, 0.1, {3, 4}};
  const Placement found = placed({}, guess);
  EXPECT_EQ(found.along, guess.along);
  EXPECT_EQ(found.shift, guess.shift);
}

TEST(Placement, TurnsAreAboutTheMiddleOfTheDrawing) {
  const std::vector<Trace> lines{arc(-100, 0), arc(300, 200)};
  const Placement guess{2.0, 0.0, {10, 20}};
  const auto turned = turned_about(guess, lines);
  ASSERT_EQ(turned.size(), 2u);
  const PxPoint middle{(-100.0 + 399.0) / 2.0, (0.0 + 230.0) / 2.0};
  for (const Placement& one : turned) {
    EXPECT_NEAR(one.scale(), 2.0, 1e-5);
    EXPECT_NEAR(geometry::distance(one(middle), guess(middle)), 0.0, 1e-9);
  }
  EXPECT_EQ(turned[0].across, -turned[1].across);
}

}  // namespace
}  // namespace penpose::portrait
