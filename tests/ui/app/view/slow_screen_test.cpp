#include <gtest/gtest.h>
#include <imgui.h>

#include "tests/support/app_desk.h"
#include "ui/app/view/draw_frame.h"
#include "ui/app/view/present/cpu_presenter.h"

// Screens that take long to change, such as electronic paper: little is put on them, and nothing moves by itself.

namespace penpose::app {
namespace {

class CountingOutput final : public PictureOutput {
 public:
  [[nodiscard]] std::optional<geometry::Viewport> size() const override { return std::nullopt; }
  [[nodiscard]] double dpi() const override { return 0; }
  void show(const render::Image& /*picture*/, const std::vector<render::PxRect>& parts) override {
    put_px = 0;
    for (const render::PxRect& part : parts) put_px += (part.right - part.left) * (part.bottom - part.top);
  }
  int put_px = 0;
};

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

TEST(SlowScreen, WhileThePenDrawsOnlyItsStripIsPutOnTheScreen) {
  SlowDesk desk("strip");
  CountingOutput output;
  const auto presenter = make_cpu_presenter(output, Rotation::none, true);
  ASSERT_TRUE(presenter->begin());
  FrameMaker frames({desk.app->of<EditingSession>(), desk.app->of<Canvas>(), desk.app->of<CanvasLook>(),
                     desk.app->of<CanvasDrawing>(), desk.app->of<Controls>(), desk.app->of<Preferences>()});
  const auto show = [&] {
    desk.frames(1);
    ASSERT_TRUE(presenter->draw(frames.make(), *ImGui::GetDrawData()));
    presenter->show();
  };
  const auto window = desk.app->of<Canvas>().window();
  const auto line = desk.mouth();
  const PxPoint from = line.front();
  desk.stroke({from, from + PxPoint{5, 0}}, false);
  show();
  EXPECT_EQ(output.put_px, window.width * window.height) << "the first picture is a whole one";
  show();
  EXPECT_EQ(output.put_px, 0) << "nothing changed";
  EXPECT_FALSE(presenter->refining());
  for (int i = 1; i <= 10; ++i) {
    desk.app->of<Pointer>().moved(from + PxPoint{5.0 + 6 * i, 0});
    show();
    EXPECT_GT(output.put_px, 0);
    EXPECT_LT(output.put_px, window.width * window.height / 50) << i;
  }
  presenter->end();
}

}  // namespace
}  // namespace penpose::app
