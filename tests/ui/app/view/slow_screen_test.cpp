#include <gtest/gtest.h>

#include "tests/support/app_desk.h"

// Screens that take long to change, such as electronic paper: nothing moves by itself.

namespace penpose::app {
namespace {

std::vector<double> pose_of(Desk& desk) { return desk.app->of<EditingSession>().shown().pose(); }

struct SlowDesk : Desk {
  explicit SlowDesk(const std::string& name) : Desk(name, "builtin:demo", true, true) { begin(); }
  std::vector<PxPoint> mouth(PxPoint by = {}) { return named_curve("lip_upper_inner", by); }
};

TEST(SlowScreen, TheFaceFollowsAPenThatRestsAndOneThatLifts) {
  SlowDesk desk("slow");
  ASSERT_FALSE(desk.mouth().empty());
  desk.stroke(desk.mouth());
  const auto before = pose_of(desk);
  desk.stroke(desk.mouth({0, 14}), false);
  EXPECT_EQ(pose_of(desk), before) << "it waits while the pen moves";
  const int wait_ms = desk.app->next_frame_ms();
  EXPECT_GT(wait_ms, 0);
  EXPECT_LE(wait_ms, 401);
  desk.now_us += 500'000;
  desk.frames();
  const auto rested = pose_of(desk);
  EXPECT_NE(rested, before);
  const PxPoint end = desk.mouth({0, 14}).back();
  desk.app->of<Pointer>().button(MouseButton::left, false, end);
  desk.frames();
  EXPECT_NE(pose_of(desk), before);
}

TEST(SlowScreen, WhatIsSaidGoesWithoutFading) {
  std::int64_t now = 0;
  Notices slow([&] { return now; }, false);
  slow.tell("said");
  now = 3'800'000;
  EXPECT_EQ(slow.opacity(slow.all().front()), 1);
  EXPECT_GT(slow.next_frame_ms(), 150) << "one frame, when it is gone";
  now = 4'000'000;
  slow.expire();
  EXPECT_TRUE(slow.all().empty());
}

}  // namespace
}  // namespace penpose::app
