#include "ui/app/tour/tour_line.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace penpose::app {
namespace {

using Line = std::vector<PxPoint>;

Line across(double y, double from = 100, double to = 300) {
  Line line;
  for (int i = 0; i <= 20; ++i) line.push_back({from + (to - from) * i / 20, y});
  return line;
}

Line ring(double x, double y, double r) {
  Line line;
  for (int i = 0; i < 32; ++i) line.push_back({x + r * std::cos(i * 0.19635), y + r * std::sin(i * 0.19635)});
  return line;
}

TEST(TourLine, ALineBesideTheOneAskedForIsNear) {
  const Line asked = across(200);
  EXPECT_TRUE(judge_line(across(212), {asked, {}, 20}).near);
  EXPECT_FALSE(judge_line(across(225), {asked, {}, 20}).near);
}

TEST(TourLine, TheDirectionInWhichItWasDrawnSaysNothing) {
  const Line asked = across(200);
  EXPECT_TRUE(judge_line(across(204, 300, 100), {asked, {}, 20}).near);
}

TEST(TourLine, APartOfItIsToldAsAPart) {
  const Line asked = across(200);
  const auto judged = judge_line(across(200, 100, 170), {asked, {}, 20});
  EXPECT_FALSE(judged.near);
  EXPECT_NE(judged.again.find("a part of it"), std::string::npos) << judged.again;
}

TEST(TourLine, MoreThanItIsToldAsMore) {
  const Line asked = across(200);
  const auto judged = judge_line(across(200, 100, 520), {asked, {}, 20});
  EXPECT_FALSE(judged.near);
  EXPECT_NE(judged.again.find("too far: stop"), std::string::npos) << judged.again;
}

TEST(TourLine, WhereItLiesIsToldByItsSide) {
  const Line asked = across(200);
  for (const auto& [line, said] : {std::pair{across(260), "Too far down"}, std::pair{across(140), "Too far up"},
                                   std::pair{across(200, 20, 220), "Too far to the left"},
                                   std::pair{across(200, 180, 380), "Too far to the right"}}) {
    const auto judged = judge_line(line, {asked, {}, 12});
    EXPECT_FALSE(judged.near) << said;
    EXPECT_EQ(judged.again.substr(0, std::string(said).size()), said);
  }
}

TEST(TourLine, AGoalDrawnWhereTheFeatureIsAlreadyIsNone) {
  const Line feature = across(200);
  const Line goal = across(215);
  EXPECT_TRUE(judge_line(across(213), {goal, feature, 20}).near);
  const auto judged = judge_line(across(201), {goal, feature, 20});
  EXPECT_FALSE(judged.near);
  EXPECT_NE(judged.again.find("already"), std::string::npos) << judged.again;
}

TEST(TourLine, ALassoMayBeginAnywhereButGoesAllAround) {
  const Line asked = ring(200, 200, 60);
  Line turned = ring(203, 198, 66);
  std::rotate(turned.begin(), turned.begin() + 11, turned.end());
  EXPECT_TRUE(judge_line(turned, {asked, {}, 20, true}).near);
  const Line half(turned.begin(), turned.begin() + 12);
  EXPECT_FALSE(judge_line(half, {asked, {}, 20, true}).near);
}

TEST(TourLine, NothingDrawnIsNotNear) {
  const Line asked = across(200);
  EXPECT_FALSE(judge_line({}, {asked, {}, 20}).near);
}

}  // namespace
}  // namespace penpose::app
