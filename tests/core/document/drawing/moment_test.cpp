#include "core/document/drawing/moment.h"

#include <gtest/gtest.h>

#include "core/document/commands/apply.h"
#include "core/document/drawing/pose_problem.h"
#include "tests/support/document_hand.h"

namespace penpose::document {
namespace {

using tests::DocumentHand;

/// A hand on the sheet of which nothing but the two shapes moves.
struct Hand : DocumentHand {
  Hand() { does(LockParameters{{"base.rx", "base.ry", "base.rz"}, true}); }

  /// A reference over the whole width, and its target higher by what "lift" does at this value.
  CurveId lifts(double y, double value) {
    does(DrawReference{view, line(-0.6, y, 0.6, y)});
    const CurveId curve{document().last_curve};
    draws(curve, y, value);
    return curve;
  }
  void draws(CurveId curve, double y, double value) {
    const double up = y + 0.4 * y * value;
    does(DrawTarget{curve, view, line(-0.6, up, 0.6, up), {}});
  }
  [[nodiscard]] std::vector<CurveId> asked() const {
    std::vector<CurveId> ids;
    if (document().moment) {
      for (const auto& one : document().moment->lines) ids.push_back(one.curve);
    }
    return ids;
  }
};

TEST(Moment, BeginsWithThePoseBeforeTheFirstLine) {
  Hand hand;
  hand.does(SetParameters{{{"lean", 0.25}}});
  const CurveId first = hand.lifts(0.8, 0.5);
  ASSERT_NEAR(hand.value("lift"), 0.5, 0.1);
  const CurveId second = hand.lifts(0.3, 0.9);
  ASSERT_TRUE(hand.document().moment);
  const Moment& moment = *hand.document().moment;
  const auto number = [&](const char* name) {
    return *rig::find_parameter(hand.document().model->rig->parameters(), name);
  };
  EXPECT_EQ(moment.base[number("lift")], 0);
  EXPECT_EQ(moment.base[number("lean")], 0.25);
  EXPECT_EQ(moment.posed, hand.document().pose);
  EXPECT_EQ(hand.asked(), (std::vector{first, second}));
}

TEST(Moment, WhatIsSetInBetweenIsNoQuestion) {
  Hand hand;
  hand.lifts(0.8, 0.5);
  hand.does(SetParameters{{{"lean", 0.5}}});
  hand.lifts(0.3, 0.5);
  EXPECT_EQ(hand.value("lean"), 0.5);
  EXPECT_NEAR(hand.value("lift"), 0.5, 0.1);
}

TEST(Moment, WhatADeletedLineDidStays) {
  Hand hand;
  const CurveId first = hand.lifts(0.8, 0.6);
  const double lifted = hand.value("lift");
  hand.does(DeleteCurve{first});
  // A line redrawn where it is.
  hand.does(DrawReference{hand.view, hand.line(-0.6, -0.5, 0.6, -0.5)});
  const CurveId second{hand.document().last_curve};
  hand.does(DrawTarget{second, hand.view, hand.line(-0.6, -0.5, 0.6, -0.5), {}});
  EXPECT_EQ(hand.value("lift"), lifted);
  EXPECT_EQ(hand.asked(), std::vector{second});
}

TEST(Moment, LinesOfAnotherTimeAskForNothing) {
  Hand hand;
  const CurveId first = hand.lifts(0.8, 0.6);
  hand.does(SetKey{0, ""});
  hand.does(SetParameters{{{"lift", 0}}});
  hand.does(SetKey{1, ""});
  hand.does(GoToTime{1});
  ASSERT_EQ(hand.value("lift"), 0);
  hand.does(DrawReference{hand.view, hand.line(-0.6, -0.5, 0.6, -0.5)});
  const CurveId second{hand.document().last_curve};
  hand.does(DrawTarget{second, hand.view, hand.line(-0.6, -0.5, 0.6, -0.5), {}});
  EXPECT_EQ(hand.value("lift"), 0);
  EXPECT_NE(find_curve(hand.document(), first), nullptr);
  EXPECT_EQ(hand.asked(), std::vector{second});
}

TEST(Moment, AReferenceDrawnAgainTakesTheFirstOnesPlace) {
  Hand hand;
  const CurveId first = hand.lifts(0.8, 0.3);
  // The same place of the sheet, where it now stands.
  const double now = 0.8 + 0.4 * 0.8 * hand.value("lift");
  const double up = 0.8 + 0.4 * 0.8 * 0.9;
  hand.does(DrawReference{hand.view, hand.line(-0.6, now, 0.6, now)});
  const CurveId second{hand.document().last_curve};
  hand.does(DrawTarget{second, hand.view, hand.line(-0.6, up, 0.6, up), {}});
  EXPECT_NEAR(hand.value("lift"), 0.9, 0.1);
  EXPECT_EQ(find_curve(hand.document(), first), nullptr) << "what was drawn anew is gone";
  EXPECT_EQ(hand.asked(), std::vector{second});
}

TEST(Moment, ASecondViewOfAFeatureCoversNothing) {
  Hand hand;
  const CurveId first = hand.lifts(0.8, 0.3);
  hand.view.camera.eye = {4, 0, 4.5};
  const auto camera = *geometry::Camera::make(hand.view.camera, hand.view.viewport);
  std::vector<PxPoint> line;
  for (const auto& p : positions_of(hand.document(), find_curve(hand.document(), first)->points))
    line.push_back(*camera.project(p));
  hand.does(DrawReference{hand.view, line});
  const CurveId second{hand.document().last_curve};
  hand.does(DrawTarget{second, hand.view, line, {}});
  EXPECT_EQ(hand.asked(), (std::vector{first, second}));
  EXPECT_TRUE(drawn_anew(*hand.document().moment).empty());
}

TEST(Moment, APartDrawnAgainLeavesTheRestAsked) {
  Hand hand;
  const CurveId first = hand.lifts(0.8, 0.3);
  const double now = 0.8 + 0.4 * 0.8 * hand.value("lift");
  hand.does(DrawReference{hand.view, hand.line(0.1, now, 0.6, now)});
  const CurveId second{hand.document().last_curve};
  hand.does(DrawTarget{second, hand.view, hand.line(0.1, now + 0.1, 0.6, now + 0.1), {}});
  ASSERT_EQ(hand.asked(), (std::vector{first, second}));
  const auto& covered = hand.document().moment->lines.front().covered;
  const auto count = std::count(covered.begin(), covered.end(), true);
  EXPECT_GT(count, static_cast<std::ptrdiff_t>(covered.size()) / 4);
  EXPECT_LT(count, static_cast<std::ptrdiff_t>(covered.size()) * 3 / 4);
  const auto problem = moment_problem(hand.document(), *hand.document().moment);
  ASSERT_EQ(problem.drawn.size(), 2U);
  EXPECT_TRUE(problem.drawn.front().before);
  EXPECT_FALSE(problem.drawn.back().before);
  EXPECT_EQ(std::count(problem.drawn.front().weights.begin(), problem.drawn.front().weights.end(), 0.0), count);
  EXPECT_EQ(problem.posed, hand.document().pose);
}

}  // namespace
}  // namespace penpose::document
