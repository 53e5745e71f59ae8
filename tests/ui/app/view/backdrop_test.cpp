#include "ui/app/view/backdrop.h"

#include <fstream>
#include <gtest/gtest.h>
#include <thread>

#include "tests/support/app_desk.h"

namespace penpose::app {
namespace {

void write_picture(const std::string& path, int width, int height, std::uint8_t value) {
  render::Image image{width, height, {}};
  image.pixels.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4, value);
  const auto bytes = render::encode_png(image);
  ASSERT_TRUE(bytes.ok());
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes->data()), static_cast<std::streamsize>(bytes->size()));
}

void show_backdrop(Desk& desk, int width, int height) {
  desk.begin();
  write_picture(desk.path("face.png"), width, height, 9);
  desk.app->of<ReferenceDesk>().open(desk.path("face.png"));
  desk.frames();
}

TEST(Backdrop, NumberedPicturesBesideItAreItsFilm) {
  Desk desk("film-frames");
  for (const char* name : {"take2.png", "take10.png", "take1.png", "other1.png", "take3.jpg", "take.png", "taken4.png"})
    write_picture(desk.path(name), 2, 2, 9);
  const auto frames = frames_beside(desk.path("take10.png"));
  ASSERT_EQ(frames.size(), 3U);
  EXPECT_EQ(std::filesystem::path(frames[0]).filename(), "take1.png");
  EXPECT_EQ(std::filesystem::path(frames[1]).filename(), "take2.png");
  EXPECT_EQ(std::filesystem::path(frames[2]).filename(), "take10.png");
  EXPECT_EQ(frames_beside(desk.path("other1.png")), std::vector<std::string>{desk.path("other1.png")});
  EXPECT_EQ(frames_beside(desk.path("take.png")).size(), 1U);
}

TEST(Backdrop, ItStandsWhereTheModelIsAndGoesAlongWithTheView) {
  Desk desk("backdrop");
  show_backdrop(desk, 30, 60);
  const auto& backdrop = desk.app->of<CanvasLook>().backdrop;
  ASSERT_NE(backdrop, nullptr);
  const auto before = backdrop->seen(desk.app->of<Canvas>().view(), desk.app->of<Canvas>().free_area());
  ASSERT_NE(before.image, nullptr);
  EXPECT_NEAR((before.to.x - before.from.x) / (before.to.y - before.from.y), 0.5, 1e-9) << "its own shape";
  EXPECT_TRUE(desk.app->of<Canvas>().free_area().holds((before.from + before.to) * 0.5));
  desk.press('+');
  const auto nearer = backdrop->seen(desk.app->of<Canvas>().view(), desk.app->of<Canvas>().free_area());
  EXPECT_GT(nearer.to.y - nearer.from.y, 1.05 * (before.to.y - before.from.y)) << "zoomed with the model";
}

TEST(Backdrop, DraggedOnTheCanvasItGoesWithThePointerAndNothingIsDrawn) {
  Desk desk("backdrop-drag");
  show_backdrop(desk, 40, 40);
  const auto before =
      desk.app->of<CanvasLook>().backdrop->seen(desk.app->of<Canvas>().view(), desk.app->of<Canvas>().free_area());
  const PxPoint from = desk.app->of<Canvas>().free_area().middle();
  desk.stroke({from, from + PxPoint{60, -30}});
  const auto after =
      desk.app->of<CanvasLook>().backdrop->seen(desk.app->of<Canvas>().view(), desk.app->of<Canvas>().free_area());
  EXPECT_NEAR(after.from.x - before.from.x, 60, 2);
  EXPECT_NEAR(after.from.y - before.from.y, -30, 2);
  EXPECT_TRUE(desk.document().curves.empty());
  // What is under the pointer stays while the wheel makes it larger.
  desk.app->of<Pointer>().moved(from);
  desk.frames();
  desk.app->of<Pointer>().wheel(3);
  desk.frames();
  const auto larger =
      desk.app->of<CanvasLook>().backdrop->seen(desk.app->of<Canvas>().view(), desk.app->of<Canvas>().free_area());
  EXPECT_GT(larger.to.x - larger.from.x, 1.1 * (after.to.x - after.from.x));
  const auto share = [&](const render::Behind& b) { return (from.x - b.from.x) / (b.to.x - b.from.x); };
  EXPECT_NEAR(share(larger), share(after), 1e-3);
  desk.click("Done##behind");
  EXPECT_FALSE(desk.app->of<CanvasLook>().backdrop->adjusting);
  desk.stroke(desk.named_curve("brow_L"));
  EXPECT_EQ(desk.document().curves.size(), 1U) << "now the canvas is the pen's again";
  desk.app->of<Actions>().run(Action::backdrop_off);
  desk.frames();
  EXPECT_EQ(desk.app->of<CanvasLook>().backdrop, nullptr);
}

TEST(Backdrop, TheFrameOfTheMomentIsShown) {
  Desk desk("backdrop-film");
  desk.begin();
  for (int i = 1; i <= 5; ++i)
    write_picture(desk.path("f00" + std::to_string(i) + ".png"), 8, 8, static_cast<std::uint8_t>(10 * i));
  desk.app->of<ReferenceDesk>().open(desk.path("f001.png"));
  const auto backdrop = desk.app->of<CanvasLook>().backdrop;
  ASSERT_EQ(backdrop->frame_count(), 5U);
  desk.app->of<Playback>().place_cursor(3.0 / desk.app->of<Playback>().rate());
  for (int i = 0; i < 200 && backdrop->frame() != 3; ++i) {
    desk.frames(1);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_EQ(backdrop->frame(), 3U);
  EXPECT_EQ(backdrop->seen(desk.app->of<Canvas>().view(), desk.app->of<Canvas>().free_area()).image->at(4, 4)[0], 40);
}

TEST(Backdrop, WhatIsNoPictureIsToldWithItsName) {
  Desk desk("backdrop-bad");
  desk.begin();
  std::ofstream(desk.path("bad.jpg")) << "no picture";
  desk.app->of<ReferenceDesk>().open(desk.path("bad.jpg"));
  EXPECT_EQ(desk.app->of<CanvasLook>().backdrop, nullptr);
  ASSERT_FALSE(desk.app->of<Notices>().all().empty());
  EXPECT_TRUE(desk.app->of<Notices>().all().back().is_error);
  EXPECT_NE(desk.app->of<Notices>().all().back().text.find("bad.jpg"), std::string::npos);
}

}  // namespace
}  // namespace penpose::app
