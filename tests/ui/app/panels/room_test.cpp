#include <gtest/gtest.h>

#include "tests/support/app_desk.h"

// Windows of any size: nothing that can be hit is cut off, and there is always a canvas.

namespace penpose::app {
namespace {

struct Size {
  int width;
  int height;
  double dpi;
};

TEST(Room, NothingIsCutOffInAnyWindowAtAnyScale) {
  Desk desk("room", "builtin:demo");
  desk.begin();
  for (const Size& size : {Size{800, 600, 96}, Size{1280, 800, 96}, Size{1280, 800, 144}, Size{1920, 1080, 144},
                           Size{3840, 2160, 96}, Size{3840, 2160, 192}}) {
    for (const Density density : {Density::compact, Density::usual, Density::touch}) {
      desk.app->of<Preferences>().settings().density = density;
      desk.app->of<Pointer>().resized({size.width, size.height}, size.dpi);
      desk.frames();
      const std::string which = std::to_string(size.width) + "x" + std::to_string(size.height) + " at " +
                                std::to_string(size.dpi) + " dpi, density " + std::to_string(static_cast<int>(density));
      for (const auto& [label, area] : desk.interface->targets()) {
        // Lists scroll: what they show in part is reached.
        const bool listed = label.find("slider") == 0 || label.find("row ") == 0 || label.find("name ") == 0 ||
                            label.find("words ") == 0 || label.find("##group") != std::string::npos ||
                            label.find("lock") != std::string::npos || label.find("##pair") != std::string::npos ||
                            label.find("##type") != std::string::npos || label.find("##reset") != std::string::npos ||
                            label.find("more##") == 0 || area.left < desk.app->of<Canvas>().free_area().left;
        EXPECT_GE(area.left, 0) << label << " in " << which;
        EXPECT_LE(area.right, size.width) << label << " in " << which;
        EXPECT_TRUE(listed || area.bottom <= size.height) << label << " in " << which;
      }
      EXPECT_GT(desk.app->of<Canvas>().free_area().width(), 0.25 * size.width) << which;
      EXPECT_GT(desk.app->of<Canvas>().free_area().height(), 0.3 * size.height) << which;
    }
  }
}

TEST(Room, ASmallScreenHasToolsAndSlidersInTurn) {
  Desk desk("small");
  desk.begin();
  for (const Size& size : {Size{480, 320, 96}, Size{480, 320, 165}, Size{800, 480, 133}, Size{1024, 600, 170}}) {
    desk.app->of<Pointer>().resized({size.width, size.height}, size.dpi);
    desk.app->of<PanelState>().shown = true;
    desk.app->of<PanelState>().side_in_turn = false;
    desk.frames();
    const std::string which = std::to_string(size.width) + "x" + std::to_string(size.height);
    bool tools = false;
    bool sliders = false;
    for (int turn = 0; turn < 3; ++turn) {
      const Area& free = desk.app->of<Canvas>().free_area();
      EXPECT_GT(free.width(), 0.3 * size.width) << which;
      EXPECT_GT(free.height(), 0.3 * size.height) << which;
      tools = tools || desk.interface->find("Pose") != nullptr;
      sliders = sliders || desk.interface->find("Poses") != nullptr;
      for (const auto& [label, area] : desk.interface->targets()) {
        EXPECT_GE(area.left, 0) << label << " in " << which;
        EXPECT_LE(area.left, size.width) << label << " in " << which;
      }
      desk.app->of<Actions>().run(Action::panels);
      desk.frames();
    }
    EXPECT_TRUE(tools) << which;
    EXPECT_TRUE(sliders) << which;
  }
}

TEST(Room, OnASmallScreenTheCanvasHasMostOfIt) {
  Desk desk("canvas");
  desk.begin();
  desk.app->of<Pointer>().resized({480, 320}, 96);
  desk.frames();
  const Area& free = desk.app->of<Canvas>().free_area();
  EXPECT_GT(free.width(), 0.7 * 480);
  EXPECT_GT(free.height(), 0.6 * 320);
}

TEST(Room, ToolsThatHaveNoRoomAreDraggedIntoView) {
  Desk desk("dragged");
  desk.begin();
  desk.app->of<Pointer>().resized({480, 320}, 96);
  desk.frames(6);
  ASSERT_EQ(desk.interface->find("Pressure"), nullptr);
  const Area hold = *desk.interface->find("Hold");
  auto& pointer = desk.app->of<Pointer>();
  for (int turn = 0; turn < 8 && desk.interface->find("Pressure") == nullptr; ++turn) {
    const PxPoint from = hold.middle();
    pointer.button(MouseButton::left, true, from);
    desk.frames(2);
    for (const double by : {12, 40, 90, 120}) {
      pointer.moved({from.x, from.y - by});
      desk.frames(2);
    }
    pointer.button(MouseButton::left, false, {from.x, from.y - 120});
    desk.frames(3);
  }
  ASSERT_NE(desk.interface->find("Pressure"), nullptr);
  EXPECT_EQ(desk.app->of<ToolInHand>().now().button.label, "Pose") << "what the drag began on was not pressed";
}

TEST(Room, EveryDialogFitsIntoASmallScreen) {
  Desk desk("dialogs");
  desk.begin();
  for (const Size& size : {Size{480, 320, 96}, Size{480, 320, 165}, Size{800, 480, 133}}) {
    desk.app->of<Pointer>().resized({size.width, size.height}, size.dpi);
    for (const Dialog dialog :
         {Dialog::open, Dialog::save, Dialog::export_as, Dialog::recent, Dialog::steps, Dialog::tablet, Dialog::pad,
          Dialog::sessions, Dialog::radial, Dialog::shortcuts, Dialog::search, Dialog::history, Dialog::film}) {
      desk.app->of<Dialogs>().show(dialog);
      desk.frames();
      for (const auto& [label, area] : desk.interface->targets()) {
        EXPECT_GE(area.left, 0) << label << " of " << dialog.name;
        EXPECT_LE(area.right, size.width) << label << " of " << dialog.name << " in " << size.width;
      }
      desk.app->of<Dialogs>().close();
      desk.frames();
    }
  }
}

TEST(Room, ANameIsTypedBySmallScreensKeysAlone) {
  Desk desk("typed");
  desk.begin();
  desk.app->of<Pointer>().resized({480, 320}, 96);
  desk.frames();
  desk.app->of<Dialogs>().show(Dialog::save);
  desk.frames();
  const std::string before = desk.app->of<Dialogs>().state<FileChoice>().name;
  ASSERT_NE(desk.interface->find("##name"), nullptr);
  desk.click("##name");
  for (const char* key : {"key a", "key b", "key 7"}) {
    ASSERT_NE(desk.interface->find(key), nullptr) << key;
    const Area area = *desk.interface->find(key);
    EXPECT_GE(area.top, 0);
    EXPECT_LE(area.bottom, 320);
    desk.click(key);
  }
  EXPECT_NE(desk.app->of<Dialogs>().state<FileChoice>().name.find("ab7"), std::string::npos);
  desk.click("key Done");
}

TEST(Room, WhatHasNoRoomStandsInAMenu) {
  Desk desk("more");
  desk.begin();
  desk.app->of<Pointer>().resized({800, 600}, 96);
  desk.frames();
  EXPECT_EQ(desk.interface->find("Onion"), nullptr);
  desk.click("More##more of time");
  desk.click("Onion");
  EXPECT_TRUE(desk.app->of<CanvasLook>().onion_skin);
}

TEST(Room, ATooltipComesOnlyToAPointerThatRests) {
  Desk desk("tooltips");
  desk.begin();
  const Area key = *desk.interface->find("Key");
  desk.app->of<Pointer>().moved(key.middle());
  desk.frames(2);
  EXPECT_GT(desk.interface->next_frame_ms(), 0) << "a tooltip comes after a while, without any event";
  EXPECT_LE(desk.interface->next_frame_ms(), 600);
  desk.frames(60);
  EXPECT_EQ(desk.interface->next_frame_ms(), -1) << "then it is there";
  desk.app->of<Pointer>().moved({600, 300});
  desk.frames(60);
  EXPECT_EQ(desk.interface->next_frame_ms(), -1) << "the canvas has none";
}

TEST(Room, TheButtonsOfTheTimelineAreHitUpToTheirEdgesAtEveryDensity) {
  Desk desk("density");
  desk.begin();
  desk.click("Key");
  for (const Size& size : {Size{1280, 800, 96}, Size{800, 600, 96}}) {
    desk.app->of<Pointer>().resized({size.width, size.height}, size.dpi);
    for (const Density density : {Density::touch, Density::compact, Density::usual}) {
      desk.app->of<Preferences>().settings().density = density;
      desk.frames();
      for (const double share : {0.06, 0.94}) {
        const Area* play = desk.interface->find("Play");
        ASSERT_NE(play, nullptr);
        const PxPoint at{play->middle().x, play->top + share * play->height()};
        desk.app->of<Pointer>().moved(at);
        desk.app->of<Pointer>().button(MouseButton::left, true, at);
        desk.app->of<Pointer>().button(MouseButton::left, false, at);
        desk.frames();
        EXPECT_TRUE(desk.app->of<Playback>().playing())
            << size.width << " px wide, density " << static_cast<int>(density) << ", at " << share;
        desk.app->of<Playback>().stop();
        desk.frames();
      }
    }
  }
}

}  // namespace
}  // namespace penpose::app
