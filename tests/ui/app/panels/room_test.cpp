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
        const bool listed = label.find("slider") == 0 || label.find("lock") != std::string::npos ||
                            label.find("##pair") != std::string::npos || label.find("##type") != std::string::npos ||
                            label.find("##reset") != std::string::npos || label.find("more##") == 0 ||
                            area.left < desk.app->of<Canvas>().free_area().left;
        EXPECT_GE(area.left, 0) << label << " in " << which;
        EXPECT_LE(area.right, size.width) << label << " in " << which;
        EXPECT_TRUE(listed || area.bottom <= size.height) << label << " in " << which;
      }
      EXPECT_GT(desk.app->of<Canvas>().free_area().width(), 0.25 * size.width) << which;
      EXPECT_GT(desk.app->of<Canvas>().free_area().height(), 0.3 * size.height) << which;
    }
  }
}

TEST(Room, WhatHasNoRoomStandsInAMenu) {
  Desk desk("more");
  desk.begin();
  desk.app->of<Pointer>().resized({800, 600}, 96);
  desk.frames();
  EXPECT_EQ(desk.interface->find("Onion"), nullptr);
  desk.click("More##more of time");
  desk.click("Onion");
  EXPECT_FALSE(desk.app->of<CanvasLook>().onion_skin);
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

}  // namespace
}  // namespace penpose::app
