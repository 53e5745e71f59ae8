#include "ui/app/dialogs/film_job.h"

#include <cstdlib>
#include <gtest/gtest.h>

#include "tests/support/app_desk.h"
#include "ui/app/dialogs/film_entry.h"

namespace penpose::app {
namespace {

TEST(FilmJob, ThereIsNothingToFilmBeforeAPoseIsKeyed) {
  Desk desk("film-nothing");
  desk.begin();
  FilmOrder order;
  order.output = desk.path("film.png");
  const auto job = FilmJob::start(desk.document(), order);
  ASSERT_FALSE(job.ok());
  EXPECT_NE(job.error().remedy.find("key"), std::string::npos);
  desk.app->of<FilmWriter>().write(order.output, order.size);
  EXPECT_TRUE(desk.app->of<Notices>().all().back().is_error);
}

TEST(FilmJob, AFilmWithoutFfmpegIsRefusedWithWhatToDo) {
  Desk desk("film-without");
  desk.begin();
  desk.click("Key");
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", desk.path("empty").c_str(), 1);
  EXPECT_FALSE(has_ffmpeg());
  FilmOrder order;
  order.output = desk.path("film.mp4");
  const auto job = FilmJob::start(desk.document(), order);
  ::setenv("PATH", path.c_str(), 1);
  ASSERT_FALSE(job.ok());
  EXPECT_NE(job.error().what.find("ffmpeg"), std::string::npos);
  EXPECT_NE(job.error().remedy.find(".png"), std::string::npos) << "pictures need none";
}

TEST(FilmJob, TheDialogWritesWhereItSays) {
  Desk desk("film-dialog");
  desk.begin();
  desk.click("Menu");
  desk.click("Film");
  ASSERT_EQ(desk.app->of<Dialogs>().open(), Dialog::film);
  desk.click("Pictures (.png)");
  EXPECT_TRUE(desk.app->of<Dialogs>().state<FileChoice>().name.ends_with(".png"));
  desk.click("1920 x 1080");
  EXPECT_EQ(desk.app->of<Dialogs>().state<FilmEntry>().size.width, 1920);
  desk.click("A film (.mp4)");
  EXPECT_TRUE(desk.app->of<Dialogs>().state<FileChoice>().name.ends_with(".mp4"));
  desk.click("Cancel");
  EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::none);
}

}  // namespace
}  // namespace penpose::app
