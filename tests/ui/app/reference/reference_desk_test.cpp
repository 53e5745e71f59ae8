#include "ui/app/reference/reference_desk.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <memory>
#include <thread>

#include "tests/support/app_desk.h"
#include "ui/app/view/backdrop.h"

namespace penpose::app {
namespace {

void write_reference(const std::string& path, std::uint8_t value) {
  render::Image image{16, 16, {}};
  image.pixels.assign(std::size_t{16} * 16 * 4, value);
  const auto bytes = render::encode_png(image);
  ASSERT_TRUE(bytes.ok());
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes->data()), static_cast<std::streamsize>(bytes->size()));
}

/// A project with a reference beside it.
std::string project_with_reference(Desk& desk) {
  write_reference(desk.path("face.png"), 9);
  desk.app->of<ReferenceDesk>().open(desk.path("face.png"));
  desk.frames();
  const std::string project = desk.path("shot.glb");
  EXPECT_TRUE(desk.app->of<Files>().save(project).ok());
  return project;
}

TEST(ReferenceDesk, WhatIsPlacedIsAStepAndKeptByTheProjectByItsName) {
  auto first = std::make_unique<Desk>("reference");
  Desk& desk = *first;
  desk.begin();
  const std::string project = project_with_reference(desk);
  ASSERT_NE(desk.document().reference, nullptr);
  EXPECT_EQ(desk.document().reference->file, "face.png") << "relative to the project beside it";
  desk.click("Card##behind");
  EXPECT_TRUE(desk.document().reference->beside);
  desk.app->of<Playback>().undo();
  desk.frames();
  EXPECT_FALSE(desk.document().reference->beside);
  EXPECT_FALSE(desk.app->of<CanvasLook>().backdrop->placed().beside) << "what is shown goes along";
  desk.click("Remove##behind");
  EXPECT_EQ(desk.document().reference, nullptr);
  EXPECT_EQ(desk.app->of<CanvasLook>().backdrop, nullptr);
  desk.app->of<Playback>().undo();
  desk.frames();
  EXPECT_NE(desk.app->of<CanvasLook>().backdrop, nullptr);
  first.reset();
  Desk again("reference-again", project);
  ASSERT_NE(again.app->of<CanvasLook>().backdrop, nullptr);
  EXPECT_FALSE(again.app->of<CanvasLook>().backdrop->adjusting) << "it was placed once";
  EXPECT_TRUE(again.app->of<ReferenceDesk>().doubt().empty());
}

TEST(ReferenceDesk, ACardStaysOnTheWindowWhileTheViewIsZoomed) {
  Desk desk("reference-card");
  desk.begin();
  write_reference(desk.path("face.png"), 9);
  desk.app->of<ReferenceDesk>().open(desk.path("face.png"), true);
  desk.frames();
  const auto seen = [&] {
    const Canvas& canvas = desk.app->of<Canvas>();
    return desk.app->of<CanvasLook>().backdrop->seen(canvas.view(), canvas.free_area());
  };
  const auto before = seen();
  desk.press('+');
  EXPECT_EQ(seen(), before);
  const PxPoint from = desk.app->of<Canvas>().free_area().middle();
  desk.stroke({from, from + PxPoint{60, 30}});
  EXPECT_NEAR(seen().from.x - before.from.x, 60, 2);
  EXPECT_NEAR(seen().from.y - before.from.y, 30, 2);
  EXPECT_NE(desk.document().reference->card.x, document::ReferencePicture().card.x) << "and the document knows";
}

TEST(ReferenceDesk, AFileThatIsAnotherOneIsSaidAndAskedAbout) {
  std::string project;
  {
    Desk desk("reference-differs");
    desk.begin();
    project = project_with_reference(desk);
    write_reference(desk.path("face.png"), 77);
  }
  auto second = std::make_unique<Desk>("reference-differs-again", project);
  Desk& again = *second;
  ReferenceDesk& references = again.app->of<ReferenceDesk>();
  EXPECT_TRUE(references.differs());
  EXPECT_NE(references.doubt().find("face.png is another file"), std::string::npos) << references.doubt();
  again.begin();
  again.click("Use it##doubt");
  EXPECT_TRUE(references.doubt().empty());
  ASSERT_TRUE(again.app->of<Files>().save(project).ok());
  second.reset();
  Desk last("reference-differs-last", project);
  EXPECT_FALSE(last.app->of<ReferenceDesk>().differs());
}

TEST(ReferenceDesk, AFileThatIsGoneIsSaidAndCanBeFoundOrRemoved) {
  std::string project;
  {
    Desk desk("reference-gone");
    desk.begin();
    project = project_with_reference(desk);
    std::filesystem::remove(desk.path("face.png"));
  }
  Desk again("reference-gone-again", project);
  again.begin();
  EXPECT_FALSE(again.app->of<ReferenceDesk>().differs());
  EXPECT_NE(again.app->of<ReferenceDesk>().doubt().find("face.png"), std::string::npos);
  again.click("Remove##doubt");
  EXPECT_EQ(again.document().reference, nullptr);
}

TEST(ReferenceDesk, AFilmIsReadIntoPicturesThatGoWithTheTimeline) {
  if (!film::has_ffmpeg()) GTEST_SKIP() << "no ffmpeg";
  Desk desk("reference-film");
  desk.begin();
  for (int i = 0; i < 6; ++i)
    write_reference(desk.path("in" + std::to_string(i) + ".png"), static_cast<std::uint8_t>(40 * i));
  const std::string film = desk.path("take.mp4");
  const std::string command =
      "ffmpeg -loglevel error -y -framerate 24 -i '" + desk.path("in%d.png") + "' -pix_fmt yuv420p '" + film + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);  // NOLINT(concurrency-mt-unsafe): a test
  ASSERT_TRUE(is_film_file(film));
  ReferenceDesk& references = desk.app->of<ReferenceDesk>();
  ASSERT_TRUE(references.open(film));
  while (references.reads() != nullptr) {
    desk.frames(1);
    std::this_thread::yield();
  }
  ASSERT_NE(desk.app->of<CanvasLook>().backdrop, nullptr);
  EXPECT_EQ(desk.app->of<CanvasLook>().backdrop->frame_count(), 6U);
  EXPECT_EQ(desk.document().reference->file, film);
}

}  // namespace
}  // namespace penpose::app
