#include "core/io/picture_lines/trace/trace_lines.h"

#include <gtest/gtest.h>
#include <string>
#include <utility>

#include "tests/support/drawings/drawn_paper.h"
#include "tests/support/random.h"

namespace penpose::io {
namespace {

using geometry::PxPoint;
using tests::Color;
using tests::DrawnPaper;
using tests::Points;

Points wave() {
  return tests::curve([](double t) { return PxPoint{40 + 420 * t, 150 + 80 * base::sin(t * 12)}; });
}
Points circle(PxPoint middle, double radius) {
  return tests::curve([&](double t) {
    const double angle = 2 * base::k_pi * t;
    return middle + PxPoint{radius * base::cos(angle), radius * base::sin(angle)};
  });
}

/// Expects every line that was drawn once, no others, each within `mean` px on the average and `ends` at its ends.
void expect_drawn(const DrawnPaper& paper, const std::vector<Points>& drawn, double mean, double ends,
                  const std::string& what) {
  const auto traced = paper.trace();
  ASSERT_TRUE(traced.ok()) << what << ": " << traced.error().line();
  ASSERT_EQ(traced->lines.size(), drawn.size()) << what;
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    tests::Deviation best{1e9, 0, 0};
    for (const PictureLine& line : traced->lines) {
      const auto one = tests::deviation(line.points, drawn[k]);
      if (one.mean + one.missed < best.mean + best.missed) best = one;
    }
    EXPECT_LT(best.mean, mean) << what << ", line " << k;
    EXPECT_LT(best.missed, ends) << what << ", line " << k;
  }
}

TEST(TraceLines, AreInTheMiddleOfTheInk) {
  for (const double width : {0.8, 1.0, 1.5, 2.0, 3.0, 5.0, 8.0, 16.0}) {
    const std::string what = std::to_string(width) + " px";
    expect_drawn(DrawnPaper(500, 300).draw(wave(), width), {wave()}, 0.1, 1.5, what);
    expect_drawn(DrawnPaper(500, 300, {20, 30, 40}).draw(wave(), width, {230, 230, 200}), {wave()}, 0.1, 1.5,
                 what + ", light on dark");
  }
}

TEST(TraceLines, WithoutSoftEdgesToo) {
  for (const double width : {2.0, 3.0, 8.0}) {
    DrawnPaper paper(500, 300);
    paper.draw(wave(), width).change([](int, int, Color& color) {
      for (double& c : color) c = c < 128 ? 0 : 255;
    });
    expect_drawn(paper, {wave()}, 0.15, 1.5, std::to_string(width));
  }
}

TEST(TraceLines, ClosedOnesStayClosed) {
  for (const double width : {1.0, 3.0, 8.0}) {
    for (const double radius : {15.0, 90.0}) {
      const Points ring = circle({250, 150}, radius);
      const auto traced = DrawnPaper(500, 300).draw(ring, width).trace();
      ASSERT_TRUE(traced.ok());
      ASSERT_EQ(traced->lines.size(), 1U) << width << " " << radius;
      EXPECT_TRUE(traced->lines[0].closed);
      EXPECT_EQ(traced->lines[0].points.front(), traced->lines[0].points.back());
      EXPECT_LT(tests::deviation(traced->lines[0].points, ring).mean, 0.25);
    }
  }
}

TEST(TraceLines, GoOnStraightWhereTheyCross) {
  const Points down{{50, 40}, {450, 260}};
  const Points up{{50, 260}, {450, 40}};
  const Points loop = tests::curve([](double t) {
    const double turn = 2 * base::k_pi * t;
    return PxPoint{60 + 380 * t + 90 * base::sin(turn), 60 + 80 * (1 - base::cos(turn)) + 30 * t};
  });
  for (const double width : {0.8, 1.0, 2.0, 3.0, 5.0, 8.0, 16.0}) {
    const std::string what = std::to_string(width) + " px";
    expect_drawn(DrawnPaper(500, 300).draw(down, width).draw(up, width), {down, up}, 0.1, 2.5, what);
    expect_drawn(DrawnPaper(500, 300).draw(loop, width), {loop}, 0.3, 1.5, what + ", over itself");
  }
}

TEST(TraceLines, ABranchIsALineOfItsOwn) {
  const Points along{{50, 150}, {450, 170}};
  const Points branch{{250, 160}, {250, 280}};
  for (const double width : {1.0, 3.0, 8.0}) {
    expect_drawn(DrawnPaper(500, 300).draw(along, width).draw(branch, width), {along, branch}, 0.1, width + 1,
                 std::to_string(width));
  }
}

TEST(TraceLines, LinesOfAnotherColourAreOthers) {
  const Points down{{50, 40}, {450, 260}};
  const Points up{{50, 260}, {450, 40}};
  const Points right{{250, 150}, {450, 150}};
  const Points left{{50, 150}, {250, 150}};
  for (const double width : {1.0, 3.0, 8.0}) {
    const std::string what = std::to_string(width) + " px";
    expect_drawn(DrawnPaper(500, 300).draw(down, width).draw(up, width, {220, 30, 30}), {down, up}, 0.1, 1.5, what);
    // They go on into each other.
    expect_drawn(DrawnPaper(500, 300).draw(left, width, {30, 60, 200}).draw(right, width, {20, 140, 40}), {left, right},
                 0.1, width + 1, what + ", end to end");
  }
  // A yellow one is as dark as its blue is.
  expect_drawn(DrawnPaper(500, 300).draw(wave(), 3, {255, 240, 0}), {wave()}, 0.1, 1, "yellow");
}

TEST(TraceLines, PaperMayBeGreyGrainyAndUnevenlyLit) {
  const Points down{{50, 40}, {450, 260}};
  tests::Random random(7);
  DrawnPaper paper(500, 300, {250, 245, 230});
  paper.draw(wave(), 3, {40, 40, 60}).draw(down, 3, {40, 40, 60}).change([&](int x, int y, Color& color) {
    const double light = 1 - 0.45 * (x / 500.0) * (y / 300.0);
    const double grain = random(-10, 10);
    for (double& c : color) c = (40 + 0.8 * c) * light + grain + random(-3, 3);
  });
  expect_drawn(paper, {wave(), down}, 0.1, 1.5, "scanned");
}

TEST(TraceLines, GapsAreJoinedAndSpecksAreNone) {
  const Points first{{40, 100}, {245, 100}};
  const Points second{{251, 100}, {460, 100}};
  DrawnPaper paper(500, 300);
  paper.draw(first, 3).draw(second, 3);
  for (int i = 0; i < 20; ++i) paper.draw(Points{{30.0 + 20 * i, 200}, {31.0 + 20 * i, 200}}, 2);
  expect_drawn(paper, {{{40, 100}, {460, 100}}}, 0.1, 1.5, "a gap");
  // Two that are far apart are two.
  expect_drawn(DrawnPaper(500, 300).draw(first, 3).draw(Points{{270, 100}, {460, 100}}, 3),
               {first, {{270, 100}, {460, 100}}}, 0.1, 1.5, "no gap");
}

TEST(TraceLines, BeginAtTheLeft) {
  const auto traced = DrawnPaper(200, 200).draw(Points{{150, 20}, {40, 180}}, 3).trace();
  ASSERT_TRUE(traced.ok());
  ASSERT_EQ(traced->lines.size(), 1U);
  EXPECT_LT(traced->lines[0].points.front().x, 60);
  EXPECT_EQ(traced->width, 200);
  EXPECT_EQ(traced->height, 200);
}

TEST(TraceLines, WhatIsTransparentIsWhite) {
  std::vector<std::uint8_t> pixels(100 * 50 * 4, 0);
  for (int y = 20; y < 23; ++y) {
    for (int x = 10; x < 90; ++x) pixels[static_cast<std::size_t>(y * 100 + x) * 4 + 3] = 255;
  }
  const auto traced = trace_lines({100, 50, pixels});
  ASSERT_TRUE(traced.ok());
  ASSERT_EQ(traced->lines.size(), 1U);
  for (const PxPoint& p : traced->lines[0].points) EXPECT_NEAR(p.y, 21.5, 0.01);
}

TEST(TraceLines, EmptyPaperAndPhotographs) {
  EXPECT_TRUE(DrawnPaper(300, 200).trace()->lines.empty());
  EXPECT_TRUE(DrawnPaper(1, 1).trace()->lines.empty());
  tests::Random random(3);
  DrawnPaper noise(600, 600);
  noise.change([&](int, int, Color& color) {
    for (double& c : color) c = random(0, 255);
  });
  const auto of_noise = noise.trace();
  ASSERT_TRUE(of_noise.ok());
  EXPECT_TRUE(of_noise->lines.empty());
  DrawnPaper stripes(2000, 2000);
  stripes.change([](int x, int y, Color& color) {
    if (x % 12 < 3 && y % 12 < 8) color = tests::k_black;
  });
  const auto many = stripes.trace();
  ASSERT_FALSE(many.ok());
  EXPECT_EQ(many.error().line(), "the picture has more than 10000 lines; choose a drawing of lines on plain paper");
  EXPECT_FALSE(trace_lines({10, 10, {}}).ok());
  EXPECT_FALSE(trace_lines({0, 0, {}}).ok());
}

TEST(TraceLines, AreTheSameEveryTime) {
  const DrawnPaper paper = DrawnPaper(500, 300).draw(wave(), 3).draw(circle({250, 150}, 70), 4, {200, 20, 20});
  const auto first = paper.trace();
  const auto second = paper.trace();
  ASSERT_TRUE(first.ok() && second.ok());
  ASSERT_EQ(first->lines.size(), second->lines.size());
  for (std::size_t i = 0; i < first->lines.size(); ++i) EXPECT_EQ(first->lines[i].points, second->lines[i].points);
}

}  // namespace
}  // namespace penpose::io
