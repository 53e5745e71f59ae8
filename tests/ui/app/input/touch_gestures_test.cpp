#include "ui/app/input/touch_gestures.h"

#include <gtest/gtest.h>

namespace penpose::app {
namespace {

using Kind = TouchAct::Kind;

TEST(TouchGestures, OneFingerDrawsFromWhereItCameDown) {
  TouchGestures touch(8);
  EXPECT_TRUE(touch.add(FingerKind::down, 1, {100, 100}).empty());
  EXPECT_TRUE(touch.add(FingerKind::move, 1, {103, 100}).empty()) << "a second finger may still come";
  const auto acts = touch.add(FingerKind::move, 1, {120, 100});
  ASSERT_EQ(acts.size(), 2U);
  EXPECT_EQ(acts[0].kind, Kind::pen_down);
  EXPECT_EQ(acts[0].at, (PxPoint{100, 100}));
  EXPECT_EQ(acts[1].kind, Kind::pen_move);
  EXPECT_EQ(touch.add(FingerKind::up, 1, {130, 100}).back().kind, Kind::pen_up);
}

TEST(TouchGestures, ATapIsAPress) {
  TouchGestures touch(8);
  EXPECT_TRUE(touch.add(FingerKind::down, 1, {100, 100}).empty());
  const auto acts = touch.add(FingerKind::up, 1, {101, 100});
  ASSERT_EQ(acts.size(), 3U);
  EXPECT_EQ(acts.front().kind, Kind::pen_down);
  EXPECT_EQ(acts.back().kind, Kind::pen_up);
}

TEST(TouchGestures, TwoFingersTurnAndZoomAndNeverDraw) {
  TouchGestures touch(8);
  touch.add(FingerKind::down, 1, {100, 100});
  touch.add(FingerKind::down, 2, {200, 100});
  double factor = 1;
  PxPoint by;
  for (int i = 1; i <= 10; ++i) {
    for (const auto& act : touch.add(FingerKind::move, 2, {200.0 + 10 * i, 100})) {
      EXPECT_TRUE(act.kind == Kind::zoom || act.kind == Kind::orbit);
      if (act.kind == Kind::zoom) factor *= act.factor;
      by = by + act.by;
    }
  }
  EXPECT_NEAR(factor, 0.5, 1e-9) << "twice as far apart is twice as near";
  EXPECT_NEAR(by.x, 50, 1e-9);
  touch.add(FingerKind::up, 2, {300, 100});
  EXPECT_TRUE(touch.add(FingerKind::move, 1, {160, 100}).empty()) << "the finger that is left over does not draw";
}

TEST(TouchGestures, APalmThatComesDownWhileAFingerDrawsIsIgnored) {
  TouchGestures touch(8);
  touch.add(FingerKind::down, 1, {100, 100});
  touch.add(FingerKind::move, 1, {140, 100});
  EXPECT_TRUE(touch.add(FingerKind::down, 2, {500, 500}).empty());
  EXPECT_TRUE(touch.add(FingerKind::move, 2, {520, 500}).empty());
  EXPECT_EQ(touch.add(FingerKind::up, 1, {150, 100}).back().kind, Kind::pen_up);
}

}  // namespace
}  // namespace penpose::app
