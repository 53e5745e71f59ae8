#include <gtest/gtest.h>

#include "tests/support/app_desk.h"

// The panel at the right: its rail, its groups, and what can be done with a row.

namespace penpose::app {
namespace {

PanelState& panels_of(const Desk& desk) { return desk.app->of<PanelState>(); }

/// A press at a place as a finger makes it: the pointer was elsewhere before.
void touch(Desk& desk, PxPoint at, int frames_held) {
  desk.app->of<PanelInput>().add(at, true);
  desk.frames(frames_held);
  desk.app->of<PanelInput>().add(at, false);
  desk.frames(6);
}

/// A list that is long enough to scroll, and a window in which all of it is seen.
void see_all(Desk& desk, int height = 1400) {
  desk.begin();
  desk.app->of<Pointer>().resized({1280, height}, 96);
  desk.frames(3);
}

TEST(SidePanel, ClosesToARailWhoseTabsOpenItAndIsKept) {
  Desk desk("rail");
  desk.begin();
  const double before = desk.app->of<Canvas>().free_area().width();
  desk.click("Close##side");
  EXPECT_GT(desk.app->of<Canvas>().free_area().width(), before + 150) << "the canvas has the room";
  EXPECT_EQ(desk.interface->find("##search"), nullptr);
  EXPECT_TRUE(load_settings(desk.path("config")).side_closed) << "it is kept";
  desk.click("Poses");
  EXPECT_TRUE(panels_of(desk).poses_tab);
  EXPECT_NE(desk.interface->find("This file##poses"), nullptr) << "a touch opens that tab";
  EXPECT_FALSE(load_settings(desk.path("config")).side_closed);
  desk.app->of<Actions>().run(Action{"side_panel"});
  desk.frames();
  EXPECT_EQ(desk.interface->find("This file##poses"), nullptr);
}

TEST(SidePanel, ARailIsThereAgainAtTheNextStart) {
  {
    Desk desk("rail-again");
    desk.begin();
    desk.click("Close##side");
  }
  Desk desk("rail-again", "builtin:demo", false);
  if (desk.interface->find("Start fresh") != nullptr) desk.click("Start fresh");
  EXPECT_NE(desk.interface->find("Open##side"), nullptr);
  EXPECT_EQ(desk.interface->find("##search"), nullptr);
}

TEST(SidePanel, AnAskedForTabOpensTheRail) {
  Desk desk("rail-asked");
  desk.begin();
  desk.click("Close##side");
  desk.press('l');
  EXPECT_NE(desk.interface->find("This file##poses"), nullptr);
}

TEST(SidePanel, FacePartsComeInTheOrderOfAFace) {
  Desk desk("parts");
  see_all(desk);
  const auto top = [&](const char* slider) {
    const Area* area = desk.interface->find(std::string("slider ") + slider);
    EXPECT_NE(area, nullptr) << slider;
    return area != nullptr ? area->top : 0;
  };
  EXPECT_LT(top("brow_inner_L"), top("mouth_corner_L"));
  EXPECT_LT(top("mouth_corner_L"), top("cheek_L"));
  EXPECT_LT(top("cheek_L"), top("jaw"));
}

TEST(SidePanel, ALongPressOpensTheMenuOfARowAndMovesNothing) {
  Desk desk("long-press");
  see_all(desk);
  const Area slider = *desk.interface->find("slider jaw");
  const PxPoint at{slider.left + 0.8 * slider.width(), slider.middle().y};
  desk.app->of<Pointer>().moved(at);
  desk.app->of<Pointer>().button(MouseButton::left, true, at);
  desk.frames(3);
  EXPECT_GT(desk.interface->next_frame_ms(), 0) << "the menu comes without any event";
  EXPECT_EQ(desk.interface->find("Reset##reset jaw"), nullptr);
  desk.frames(40);
  ASSERT_NE(desk.interface->find("Reset##reset jaw"), nullptr);
  desk.let_go(at);
  EXPECT_NE(desk.interface->find("Reset##reset jaw"), nullptr) << "letting go presses nothing";
  EXPECT_EQ(desk.value_of("jaw"), 0);
  desk.click("Lock it##lock jaw");
  EXPECT_EQ(desk.document().locked, std::vector<std::string>{"jaw"});
  EXPECT_EQ(desk.interface->find("Reset##reset jaw"), nullptr) << "an entry closes the menu";
}

TEST(SidePanel, QuickButtonsComeUnderAPointerThatHoversAndNotUnderAFinger) {
  Desk desk("quick");
  see_all(desk);
  EXPECT_EQ(desk.interface->find("##lock jaw"), nullptr);
  desk.hover("name jaw");
  EXPECT_NE(desk.interface->find("##lock jaw"), nullptr);
  EXPECT_NE(desk.interface->find("\u21ba##reset jaw"), nullptr);
  const Area lock = *desk.interface->find("##lock jaw");
  EXPECT_GE(lock.width(), 32) << "a pen hits it";
  desk.app->of<Pointer>().moved({600, 300});
  desk.frames();
  EXPECT_EQ(desk.interface->find("##lock jaw"), nullptr);
  touch(desk, lock.middle(), 4);
  EXPECT_TRUE(desk.document().locked.empty()) << "what came under the finger was not meant";
  EXPECT_NE(desk.interface->find("Reset##reset jaw"), nullptr) << "a touch of the name opens the menu";
}

TEST(SidePanel, MovedRowsComeOnTopWithoutJumpingUnderThePen) {
  Desk desk("moved-top");
  see_all(desk, 700);
  const auto moved_group = [&] {
    for (const auto& [label, area] : desk.interface->targets()) {
      if (label.ends_with("##group Moved")) return true;
    }
    return false;
  };
  const Area before = *desk.interface->find("slider brow_inner_L");
  desk.drag_slider("brow_inner_L", 0.5, 0.9, false);
  EXPECT_FALSE(moved_group()) << "nothing comes while it is in hand";
  EXPECT_EQ(desk.interface->find("slider brow_inner_L")->top, before.top);
  desk.let_go({before.left + 0.9 * before.width(), before.middle().y});
  EXPECT_EQ(desk.interface->find("slider brow_inner_L")->top, before.top) << "it stays under the pen";
  desk.app->of<Pointer>().moved({500, 300});
  desk.frames(6);
  EXPECT_TRUE(moved_group()) << "seen as soon as the pen is elsewhere";
  EXPECT_NE(desk.interface->find("slider brow_inner_L"), nullptr);
}

TEST(SidePanel, AGroupIsMovedAloneOrLeftOut) {
  Desk desk("group-alone");
  see_all(desk);
  const auto choose = [&](const std::string& entry) {
    desk.touch_row("name brow_inner_L");
    ASSERT_NE(desk.interface->find(entry), nullptr) << entry;
    desk.click(entry);
  };
  choose("Only this group##group");
  const auto locked = desk.document().locked;
  EXPECT_NE(std::find(locked.begin(), locked.end(), "jaw"), locked.end());
  EXPECT_EQ(std::find(locked.begin(), locked.end(), "brow_inner_L"), locked.end());
  choose("All groups again##group");
  EXPECT_TRUE(desk.document().locked.empty());
  choose("Not this group##group");
  EXPECT_EQ(desk.document().locked.front().substr(0, 4), "brow");
  choose("This group again##group");
  EXPECT_TRUE(desk.document().locked.empty());
}

}  // namespace
}  // namespace penpose::app
