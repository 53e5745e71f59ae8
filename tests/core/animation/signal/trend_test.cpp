#include "core/animation/signal/trend.h"

#include <cmath>
#include <gtest/gtest.h>

#include "tests/support/models/rendered_track.h"

namespace penpose::animation {
namespace {

using Rows = std::vector<std::vector<double>>;

const std::vector<double> k_trusted(60, 1.0);

/// A line that goes up for 8 frames and down for 12, in 6 columns, and stands still elsewhere.
Rows blink(double shake) {
  tests::Shaker random(3);
  Rows rows;
  for (int f = 0; f < 60; ++f) {
    const double value = f < 20 ? 0 : f < 28 ? f - 20 : f < 40 ? 8 - (f - 28) * 8 / 12.0 : 0;
    std::vector<double>& row = rows.emplace_back();
    for (int i = 0; i < 6; ++i) row.push_back(value + shake * random());
  }
  return rows;
}

TEST(Trend, TremorGoesOnTheSlopesToo) {
  const Rows clean = blink(0);
  const Rows shaken = blink(1);
  Rows found = shaken;
  follow_trend(k_trusted, 0.58, found);
  double before = 0;
  double after = 0;
  for (std::size_t f = 1; f < 60; ++f) {
    const double step = clean[f][0] - clean[f - 1][0];
    before += std::abs(shaken[f][0] - shaken[f - 1][0] - step);
    after += std::abs(found[f][0] - found[f - 1][0] - step);
    EXPECT_NEAR(found[f][0], clean[f][0], 1) << f;
  }
  EXPECT_LT(after, before / 5);
}

TEST(Trend, CornersStayInTheirPlace) {
  const Rows clean = blink(0);
  Rows found = clean;
  follow_trend(k_trusted, 0.58, found);
  for (std::size_t f = 0; f < 60; ++f) EXPECT_NEAR(found[f][5], clean[f][5], 0.5) << f;
}

TEST(Trend, OneColumnMayMoveWhileTheOthersRest) {
  Rows rows = blink(0);
  for (auto& row : rows) std::fill(row.begin() + 1, row.end(), 0.0);
  follow_trend(k_trusted, 0.58, rows);
  for (const auto& row : rows) EXPECT_NEAR(row[3], 0, 1e-9);
  EXPECT_GT(rows[28][0], 6);
}

TEST(Trend, LinesStayAndSoDoesEverythingWithoutTremor) {
  Rows rows;
  for (int f = 0; f < 60; ++f) rows.push_back({0.3 * f - 5, 7});
  const Rows before = rows;
  follow_trend(k_trusted, 2, rows);
  for (std::size_t f = 0; f < 60; ++f) EXPECT_NEAR(rows[f][0], before[f][0], 1e-9);
  rows = blink(1);
  follow_trend(k_trusted, 0, rows);
  EXPECT_EQ(rows, blink(1));
  for (const std::size_t frames : {0U, 1U, 2U}) {
    Rows few(frames, {1.0, 2.0});
    follow_trend(std::span(k_trusted).first(frames), 1, few);
    EXPECT_EQ(few, Rows(frames, {1.0, 2.0}));
  }
}

TEST(Trend, NextToNoTremorChangesNextToNothing) {
  const Rows before = blink(1);
  Rows rows = before;
  follow_trend(k_trusted, 1e-6, rows);
  for (std::size_t f = 0; f < 60; ++f) {
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(rows[f][i], before[f][i], 1e-4) << f;
  }
}

TEST(Trend, AFrameOfNoTrustIsBridged) {
  Rows rows = blink(0);
  std::vector<double> trust = k_trusted;
  for (std::size_t f = 10; f < 13; ++f) {
    rows[f].assign(6, 100.0);
    trust[f] = 1e-3;
  }
  follow_trend(trust, 0.58, rows);
  EXPECT_NEAR(rows[11][0], 0, 1);
}

}  // namespace
}  // namespace penpose::animation
