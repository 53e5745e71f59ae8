#include "ui/app/view/toast_place.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "tests/support/app_desk.h"

namespace penpose::app {
namespace {

TEST(ToastPlace, ItCoversNothingThatIsDrawnWhereACornerIsFree) {
  const Area canvas{100, 50, 900, 650};
  const std::vector<PxPoint> corners{{110, 640}, {890, 640}, {110, 60}, {890, 60}};
  for (std::size_t free = 0; free < corners.size(); ++free) {
    std::vector<PxPoint> drawn;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (i != free) drawn.push_back(corners[i]);
    }
    const Area place = toast_place(canvas, 200, 40, drawn);
    for (const PxPoint& p : drawn) EXPECT_FALSE(place.holds(p)) << free;
    EXPECT_TRUE(canvas.holds({place.left, place.top})) << free;
    EXPECT_NEAR(place.width(), 200, 1e-9);
  }
  const Area usual = toast_place(canvas, 200, 40, {});
  EXPECT_EQ(usual.left, 100);
  EXPECT_EQ(usual.bottom, 650);
}

TEST(ToastPlace, WhatIsSaidGoesAfterFourSeconds) {
  Desk desk("toast");
  desk.begin();
  desk.app->of<Notices>().tell("something happened");
  desk.frames(200);  // 3.2 s
  ASSERT_EQ(desk.app->of<Notices>().all().size(), 1U);
  EXPECT_GE(desk.app->next_frame_ms(), 0) << "it goes without an event";
  desk.frames(60);
  EXPECT_TRUE(desk.app->of<Notices>().all().empty());
  EXPECT_EQ(desk.app->next_frame_ms(), -1) << "then nothing is to be drawn any more";
}

std::vector<PxPoint> drawn(Desk& desk) {
  return drawn_px(desk.app->of<Canvas>().view(), desk.app->of<CanvasDrawing>().curves);
}

TEST(ToastPlace, LinesOnTheCanvasAreKnown) {
  Desk desk("toast-lines");
  desk.begin();
  desk.hit_escape();  // the features that are shown on opening go
  EXPECT_TRUE(drawn(desk).empty());
  const auto line = desk.named_curve(any_curve(desk));
  desk.stroke(line);
  const auto points = drawn(desk);
  ASSERT_FALSE(points.empty());
  const auto near = [&](const PxPoint& p) {
    return std::any_of(points.begin(), points.end(), [&](const PxPoint& q) { return geometry::distance(p, q) < 12; });
  };
  for (const PxPoint& p : line) EXPECT_TRUE(near(p));
}

}  // namespace
}  // namespace penpose::app
