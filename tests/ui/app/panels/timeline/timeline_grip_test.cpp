#include <gtest/gtest.h>

#include "tests/support/app_desk.h"
#include "ui/app/settings.h"

// The upper edge of the timeline.

namespace penpose::app {
namespace {

TEST(TimelineGrip, TheSheetAndTheCurvesEachKeepTheHeightThatTheyWereDraggedTo) {
  Desk desk("grip");
  desk.begin();
  EXPECT_EQ(desk.interface->find("timeline grip"), nullptr) << "there are no rows to size";
  desk.press('t');
  const double usual = desk.interface->find("sheet")->height();
  const Area grip = *desk.interface->find("timeline grip");
  EXPECT_GE(grip.height(), 32) << "high enough for a pen";
  desk.pull(grip.middle(), {grip.middle().x, grip.middle().y + 60});
  const double lower = desk.interface->find("sheet")->height();
  EXPECT_NEAR(lower, usual - 60, 3);
  desk.press('t', false, true);
  EXPECT_NEAR(desk.interface->find("curves")->height(), usual, 1) << "the curves have their own";
  const Area other = *desk.interface->find("timeline grip");
  desk.pull(other.middle(), {other.middle().x, other.middle().y - 40});
  EXPECT_NEAR(desk.interface->find("curves")->height(), usual + 40, 3);
  desk.press('t');
  EXPECT_NEAR(desk.interface->find("sheet")->height(), lower, 1);
  const Settings kept = load_settings(desk.path("config"));
  EXPECT_GT(kept.sheet_height, 0);
  EXPECT_GT(kept.curves_height, kept.sheet_height);
}

}  // namespace
}  // namespace penpose::app
