#include "ui/app/input/drag_scroll.h"

#include <gtest/gtest.h>

namespace penpose::app {
namespace {

constexpr double k_slack_px = 8;

class DragScrolls : public testing::Test {
 protected:
  DragScrolls() { scroll.set_areas({{{0, 0, 200, 400}, 1}, {{0, 200, 200, 400}, 2}, {{0, 300, 200, 400}, 0}}); }
  /// What the panels are told, as "x,y+" where it is pressed and "x,y-" where not.
  std::string told(double x, double y, bool down) {
    std::string text;
    for (const PanelPointer& one : scroll.add({{x, y}, down}, k_slack_px)) {
      text += std::to_string(static_cast<int>(one.at.x)) + ',' + std::to_string(static_cast<int>(one.at.y)) +
              (one.down ? "+ " : "- ");
    }
    return text;
  }
  DragScroll scroll;
};

TEST_F(DragScrolls, APressThatTremblesIsAPress) {
  EXPECT_EQ(told(50, 100, true), "50,100- ");
  EXPECT_EQ(told(53, 104, true), "");
  EXPECT_EQ(told(54, 105, false), "50,100+ 50,100- ");
  EXPECT_FALSE(scroll.take());
}

TEST_F(DragScrolls, ADragUpOrDownMovesWhatIsUppermostAndPressesNothing) {
  EXPECT_EQ(told(50, 290, true), "50,290- ");
  EXPECT_EQ(told(52, 270, true), "");
  EXPECT_EQ(told(90, 190, true), "");
  ASSERT_EQ(scroll.take(), std::pair(2U, -100.0));
  EXPECT_FALSE(scroll.take()) << "each px once";
  EXPECT_EQ(told(90, 195, false), "");
  EXPECT_EQ(scroll.take(), std::pair(2U, 5.0));
  EXPECT_FALSE(scroll.active());
  EXPECT_EQ(told(10, 10, false), "10,10- ") << "then the pointer moves as before";
}

TEST_F(DragScrolls, ADragToTheSideIsTheWidgets) {
  told(50, 100, true);
  EXPECT_EQ(told(70, 104, true), "50,100+ 70,104+ ") << "a slider begins where it was touched";
  EXPECT_EQ(told(70, 160, true), "70,160+ ");
  EXPECT_EQ(told(70, 160, false), "70,160- ");
  EXPECT_FALSE(scroll.take());
}

TEST_F(DragScrolls, ElsewherePressesAreToldAtOnce) {
  EXPECT_EQ(told(300, 100, true), "300,100+ ");
  EXPECT_EQ(told(300, 200, true), "300,200+ ");
  EXPECT_EQ(told(300, 200, false), "300,200- ");
  EXPECT_EQ(told(50, 350, true), "50,350+ ") << "drawn into, not scrolled";
}

TEST_F(DragScrolls, WhatIsDroppedWhileItIsHeldPressesNothingUntilTheNextPress) {
  EXPECT_EQ(told(50, 100, true), "50,100- ");
  EXPECT_TRUE(scroll.held());
  scroll.drop();
  EXPECT_FALSE(scroll.held());
  EXPECT_EQ(told(90, 100, true), "90,100- ");
  EXPECT_EQ(told(90, 100, false), "90,100- ");
  EXPECT_EQ(told(50, 100, true), "50,100- ");
  EXPECT_EQ(told(50, 100, false), "50,100+ 50,100- ");
}

TEST_F(DragScrolls, WhatScrollsIsNoLongerHeld) {
  EXPECT_EQ(told(50, 100, true), "50,100- ");
  EXPECT_EQ(told(50, 130, true), "");
  EXPECT_FALSE(scroll.held());
  scroll.drop();
  EXPECT_TRUE(scroll.active()) << "it goes on scrolling";
}

}  // namespace
}  // namespace penpose::app
