#include "tests/judges/hands/hand.h"

#include <cmath>
#include <gtest/gtest.h>

namespace penpose::judges {
namespace {

using geometry::PxPoint;

std::vector<PxPoint> bow() {
  std::vector<PxPoint> line;
  for (int i = 0; i <= 30; ++i) line.push_back({10.0 * i, 0.02 * (10.0 * i) * (300 - 10.0 * i) / 10});
  return line;
}

double off(const std::vector<PxPoint>& a, const std::vector<PxPoint>& b) {
  double square = 0;
  for (std::size_t i = 0; i < a.size(); ++i) square += geometry::dot(a[i] - b[i], a[i] - b[i]);
  return std::sqrt(square / static_cast<double>(a.size()));
}

double length(const std::vector<PxPoint>& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += geometry::distance(line[i - 1], line[i]);
  return sum;
}

TEST(JudgesHand, AnExactHandDrawsTheLineEvenly) {
  const auto drawn = drawn_by(hand_named("exact"), bow(), 7);
  EXPECT_LT(off(drawn, resampled(bow(), 40)), 1e-9);
  EXPECT_NEAR(geometry::distance(drawn[0], drawn[1]), geometry::distance(drawn[38], drawn[39]), 0.1);
}

TEST(JudgesHand, TheSameSeedDrawsTheSameLine) {
  for (const Hand& hand : all_hands()) {
    EXPECT_EQ(drawn_by(hand, bow(), 3), drawn_by(hand, bow(), 3)) << hand.name;
    const bool another = drawn_by(hand, bow(), 3) != drawn_by(hand, bow(), 4);
    EXPECT_EQ(another, hand.tremor_px > 0) << hand.name;
  }
}

TEST(JudgesHand, TremorStraysByItsPx) {
  for (const double px : {1.0, 2.0}) {
    double square = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      const double one = off(drawn_by({.name = "", .tremor_px = px}, bow(), seed), resampled(bow(), 40));
      square += one * one / 200;
    }
    // In x and in y.
    EXPECT_NEAR(std::sqrt(square / 2), px, 0.1 * px);
  }
}

TEST(JudgesHand, AnUnevenHandIsUpToFourTimesAsFast) {
  const auto drawn = drawn_by({.name = "", .uneven = 0.6}, bow(), 5);
  double least = 1e9;
  double most = 0;
  for (std::size_t i = 1; i < drawn.size(); ++i) {
    least = std::min(least, geometry::distance(drawn[i - 1], drawn[i]));
    most = std::max(most, geometry::distance(drawn[i - 1], drawn[i]));
  }
  EXPECT_NEAR(most / least, 4, 0.5);
}

TEST(JudgesHand, OthersDrawBackwardsTooShortTooLongOrOfAnotherSize) {
  const auto back = drawn_by({.name = "", .backwards = true}, bow(), 5);
  EXPECT_LT(geometry::distance(back.front(), bow().back()), 1e-9);
  bool shorter = false;
  bool longer = false;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const double share = length(drawn_by({.name = "", .ends = 0.12}, bow(), seed)) / length(bow());
    EXPECT_NEAR(share, 1, 0.25);
    shorter = shorter || share < 0.95;
    longer = longer || share > 1.05;
    EXPECT_NEAR(length(drawn_by({.name = "", .wobbly_scale = 0.08}, bow(), seed)) / length(bow()), 1, 0.081);
  }
  EXPECT_TRUE(shorter && longer);
}

}  // namespace
}  // namespace penpose::judges
