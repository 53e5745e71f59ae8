#include <cmath>
#include <gtest/gtest.h>

#include "core/intent/choosing/selection.h"
#include "core/intent/solve.h"
#include "tests/core/intent/face.h"

// What is asked for more than it can hardly is meant, a hand that goes far is less exact,
// and a left and right pair costs no more than one control.

namespace penpose::intent {
namespace {

using tests::Face;
using tests::fade;
using tests::Line;

/// A smile that lifts the corners and leaves the middle, and lips that are pressed: all of the line comes up a little.
Face mouth_face() {
  Face face;
  face.bump("browLeft", -0.4, 0.5, {0, 0.15, 0});
  face.control("smile", [](double x, double y) {
    return geometry::ModelVector{0, std::abs(x) < 0.6 ? 0.9 * x * x * fade(y + 0.4) : 0.0, 0};
  });
  face.control("press", [](double x, double y) {
    return geometry::ModelVector{0, std::abs(x) < 0.6 ? (0.03 + 0.12 * x * x) * fade(y + 0.4) : 0.0, 0};
  });
  face.ready();
  return face;
}

TEST(Near, ASmallSmileDrawnALittleTooHighIsNoPressedLips) {
  const Face face = mouth_face();
  std::size_t right = 0;
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    Line line = face.seen(Face::mouth(), face.pose({{"smile", 0.3}}));
    for (auto& p : line) p.y -= 6;
    line = tests::shaken(line, 0.7, seed);
    const Solution solution = face.read(Face::mouth(), line);
    if (solution.moved != std::vector<std::size_t>{face.number("smile")}) continue;
    ++right;
    EXPECT_NEAR(solution.pose[face.number("smile")], 0.3, 0.16) << seed;
  }
  EXPECT_GE(right, 5U) << "of 6 unsteady hands";
}

TEST(Near, WhatIsPressedIsPressed) {
  const Face face = mouth_face();
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const Line line = tests::shaken(face.seen(Face::mouth(), face.pose({{"press", 0.7}})), 0.7, seed);
    const Solution solution = face.read(Face::mouth(), line);
    EXPECT_EQ(solution.moved, std::vector<std::size_t>{face.number("press")}) << seed;
  }
}

TEST(Near, WhatStandsNearItsLimitCostsInParts) {
  Choices choices;
  choices.units.push_back({{0, 0, 0}, 1, false, 0});
  choices.low = {0};
  choices.high = {2};
  EXPECT_DOUBLE_EQ(share_of_range(1.8, 0, choices), 0.9);
  EXPECT_DOUBLE_EQ(share_of_range(3.0, 0, choices), 1.0);
  EXPECT_DOUBLE_EQ(share_of_range(-1.0, 0, choices), 1.0) << "there is no way down";
  EXPECT_DOUBLE_EQ(share_of_range(0.0, 0, choices), 0.0);
  Costs costs;
  costs.limit = 8;
  costs.limit_from = 0.8;
  Quadratic quadratic;
  const Selection selection(quadratic, choices, costs);
  const auto of = [&](double value) { return selection.limit_costs({{0}, {0}, {value}, 0, 0}); };
  EXPECT_DOUBLE_EQ(of(1.5), 0);
  EXPECT_NEAR(of(1.8), 4, 1e-12);
  EXPECT_NEAR(of(2.0), 8, 1e-12);
}

TEST(Near, AnArcDrawnFarAwayIsOneControlsRatherThanTwos) {
  Face face;
  const auto drops = [&](const char* name, double narrow) {
    face.control(name, [=](double x, double y) {
      const double at = std::abs(x) < 0.6 ? std::max(0.0, 1 - narrow * x * x) * fade(y + 0.4) : 0.0;
      return geometry::ModelVector{0, -0.2 * at, 0};
    });
  };
  drops("narrow", 8);
  drops("wide", 4);
  face.ready();
  const Line rest = face.seen(Face::mouth(), rig::rest_pose(*face.rig));
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Line line = rest;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const double at = 2.0 * static_cast<double>(i) / static_cast<double>(line.size() - 1) - 1.0;
      line[i].y += 60 * (1 - at * at);
    }
    line = tests::shaken(line, 1, seed);
    EXPECT_EQ(face.read(Face::mouth(), line).moved.size(), 1U) << seed;
  }
}

}  // namespace
}  // namespace penpose::intent
