#include "ui/app/controls/controls.h"

#include <gtest/gtest.h>

#include "tests/support/app_desk.h"

// A control that was just made is seen at its target before it is used.

namespace penpose::app {
namespace {

const rig::Pose& shown(Desk& desk) { return desk.app->of<EditingSession>().shown().pose(); }

TEST(NewControl, IsSeenAtItsTargetAndStandsAtRestInTheDocument) {
  Desk desk("new-control");
  desk.begin();
  sketch_chin(desk);
  const std::size_t number = desk.index_of("control 1");
  EXPECT_EQ(shown(desk)[number], 1);
  EXPECT_EQ(desk.document().pose[number], 0);
  desk.click("Back to rest##trial");
  EXPECT_EQ(shown(desk)[number], 0);
  EXPECT_EQ(desk.interface->find("Back to rest##trial"), nullptr);
}

TEST(NewControl, GoesBackToRestWithTheNextLine) {
  Desk desk("next-line");
  desk.begin();
  sketch_chin(desk);
  const std::size_t number = desk.index_of("control 1");
  ASSERT_EQ(shown(desk)[number], 1);
  desk.press('b');
  desk.stroke(desk.named_curve("brow_L"));
  EXPECT_EQ(shown(desk)[number], 0);
  EXPECT_EQ(desk.app->of<Controls>().trial(), nullptr);
}

TEST(NewControl, IsKeyedAsItIsSeen) {
  Desk desk("keyed");
  desk.begin();
  sketch_chin(desk);
  desk.click("Key");
  const std::size_t number = desk.index_of("control 1");
  ASSERT_EQ(desk.document().timeline->keys.size(), 1U);
  EXPECT_EQ(desk.document().timeline->keys.front().pose[number], 1);
}

TEST(NewControl, StaysAtItsTargetWhereThatIsWanted) {
  Desk desk("stays");
  desk.begin();
  sketch_chin(desk);
  desk.click("Stay there##trial");
  EXPECT_EQ(desk.value_of("control 1"), 1);
  desk.press('z', true);
  EXPECT_EQ(desk.value_of("control 1"), 0) << "a step";
}

}  // namespace
}  // namespace penpose::app
