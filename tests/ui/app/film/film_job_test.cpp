#include "ui/app/film/film_job.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/support/app_desk.h"
#include "tests/support/sound_files.h"
#include "ui/app/film/film_entry.h"
#include "ui/app/film/film_writer.h"
#include "ui/film/ffmpeg.h"
#include "ui/render/picture/image.h"

namespace penpose::app {
namespace {

namespace fs = std::filesystem;
using film::FilmKind;

/// A desk whose home is its own folder, with two keys.
class FilmDesk : public ::testing::Test {
 protected:
  FilmDesk() : desk_("film") {
    desk_.begin();
    before_ = std::getenv("HOME") != nullptr ? std::getenv("HOME") : "";
    ::setenv("HOME", desk_.folder.c_str(), 1);
    ::unsetenv("XDG_CONFIG_HOME");
    writer().use_program(PENPOSE_PROGRAM);
  }
  ~FilmDesk() override { ::setenv("HOME", before_.c_str(), 1); }

  void key_twice() {
    desk_.click("Key");
    desk_.app->of<Playback>().go_to(0.25);
    desk_.click("Key");
  }
  FilmWriter& writer() { return desk_.app->of<FilmWriter>(); }
  FileChoice& choice() { return desk_.app->of<Dialogs>().state<FileChoice>(); }
  FilmEntry& entry() { return desk_.app->of<Dialogs>().state<FilmEntry>(); }
  const Notice& said() { return desk_.app->of<Notices>().all().back(); }
  void open_dialog() {
    desk_.open_menu("File");
    desk_.click("Film");
    ASSERT_EQ(desk_.app->of<Dialogs>().open(), Dialog::film);
  }
  /// The window goes on until the film is there or is not; false: it takes too long.
  bool wait() {
    constexpr int k_looks = 6000;
    for (int i = 0; i < k_looks && writer().writes(); ++i) {
      desk_.frames(1);
      ::usleep(10'000);
    }
    return !writer().writes();
  }
  std::size_t files_in(const fs::path& folder) const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }
  void without_ffmpeg(const std::function<void()>& run) {
    const std::string path = std::getenv("PATH");
    ::setenv("PATH", desk_.path("empty").c_str(), 1);
    EXPECT_FALSE(film::has_ffmpeg());
    run();
    ::setenv("PATH", path.c_str(), 1);
  }

  Desk desk_;
  std::string before_;
};

TEST_F(FilmDesk, ThereIsNothingToFilmBeforeAPoseIsKeyed) {
  EXPECT_FALSE(writer().write(desk_.path("film.png"), {}));
  EXPECT_TRUE(said().is_error);
  EXPECT_NE(said().text.find("key a pose first"), std::string::npos) << said().text;
}

TEST_F(FilmDesk, AFilmWithoutFfmpegIsRefusedWithWhatToDo) {
  key_twice();
  without_ffmpeg([&] {
    EXPECT_FALSE(writer().write(desk_.path("film.mp4"), {}));
    EXPECT_NE(said().text.find("install the package ffmpeg"), std::string::npos) << said().text;
    EXPECT_NE(said().text.find(".png"), std::string::npos) << "pictures need none";
    // The dialog offers them at once, and says so of all else.
    open_dialog();
    EXPECT_TRUE(choice().name.ends_with(".png")) << choice().name;
    desk_.click("Film (.webm)");
    const std::string webm = choice().name;
    desk_.click("Write##film");
    EXPECT_EQ(desk_.app->of<Dialogs>().open(), Dialog::film) << "it cannot be pressed";
    EXPECT_FALSE(writer().writes());
    desk_.click("Cancel");
  });
}

TEST_F(FilmDesk, TheDialogTakesTheKindByItsNameAndByTheEnding) {
  key_twice();
  open_dialog();
  for (const auto& [label, ending, kind] :
       {std::tuple{"Pictures (.png)", ".png", FilmKind::pictures}, std::tuple{"GIF (.gif)", ".gif", FilmKind::gif},
        std::tuple{"Film (.webm)", ".webm", FilmKind::webm}, std::tuple{"Sheet (.png)", ".png", FilmKind::sheet},
        std::tuple{"Film (.mp4)", ".mp4", FilmKind::mp4}}) {
    desk_.click(label);
    EXPECT_TRUE(choice().name.ends_with(ending)) << choice().name;
    EXPECT_EQ(entry().kind, kind) << label;
  }
  for (const auto& [name, kind] : {std::pair{"a.GIF", FilmKind::gif}, std::pair{"a.webm", FilmKind::webm},
                                   std::pair{"a", FilmKind::webm}, std::pair{"a.png", FilmKind::pictures}}) {
    choice().name = name;
    desk_.frames();
    EXPECT_EQ(entry().kind, kind) << name;
  }
  desk_.click("1920 x 1080");
  EXPECT_EQ(entry().size->width, 1920);
  desk_.click("Canvas");
  EXPECT_FALSE(entry().size);
  desk_.click("Cancel");
  EXPECT_EQ(desk_.app->of<Dialogs>().open(), Dialog::none);
}

TEST_F(FilmDesk, PicturesAreWrittenAndWrittenOverOnlyWhenAskedTwice) {
  key_twice();
  open_dialog();
  choice().name = "shot.png";
  choice().folder = desk_.folder.string();
  entry().size = geometry::Viewport{96, 54};
  desk_.frames();
  desk_.click("Write##film");
  EXPECT_EQ(desk_.app->of<Dialogs>().open(), Dialog::none);
  ASSERT_TRUE(writer().writes());
  ASSERT_TRUE(wait());
  EXPECT_EQ(said().text, "written: " + desk_.path("shot0000.png") + " and on");
  for (int frame = 0; frame <= 6; ++frame)
    EXPECT_TRUE(fs::exists(desk_.path("shot000" + std::to_string(frame) + ".png"))) << frame;
  EXPECT_FALSE(fs::exists(desk_.path("shot0007.png")));
  open_dialog();
  choice().name = "shot.png";
  desk_.frames();
  desk_.click("Write##film");
  EXPECT_FALSE(writer().writes());
  EXPECT_NE(desk_.interface->find("Write over it##film"), nullptr);
  desk_.click("Cancel");
}

TEST_F(FilmDesk, APlayblastGoesBesideTheProjectWithTheSoundAndTheSizeOfTheCanvas) {
  if (!film::has_ffmpeg()) GTEST_SKIP() << "no ffmpeg";
  key_twice();
  fs::create_directory(desk_.path("shots"));
  std::ofstream sound(desk_.path("shots/talk.wav"), std::ios::binary);
  const auto bytes = tests::wav_bytes(tests::tone(440, 8000, 1), 8000);
  sound.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  sound.close();
  ASSERT_TRUE(desk_.app->of<Files>().save(desk_.path("shots/face.glb")).ok());
  desk_.app->of<SoundTrack>().open(desk_.path("shots/talk.wav"));
  desk_.frames();
  const bool sounds = desk_.app->of<SoundTrack>().sound() != nullptr;
  desk_.app->of<Playback>().loop() = {1.0 / 24, 3.0 / 24};
  for (const char* name : {"face-playblast.mp4", "face-playblast-2.mp4"}) {
    desk_.app->of<Actions>().run(Action{"playblast"});
    EXPECT_EQ(desk_.app->of<Dialogs>().open(), Dialog::none) << "it asks nothing";
    ASSERT_TRUE(wait());
    EXPECT_EQ(said().text, "written: " + desk_.path("shots/" + std::string(name)));
  }
  const std::string probe =
      "ffprobe -v error -count_frames -show_entries stream=codec_type,width,height,nb_read_frames "
      "-of csv=p=0 " +
      desk_.path("shots/face-playblast.mp4") + " > " + desk_.path("probed");
  ASSERT_EQ(std::system(probe.c_str()), 0);
  std::ifstream probed(desk_.path("probed"));
  std::string video, audio;
  std::getline(probed, video);
  std::getline(probed, audio);
  const auto size = film_size(desk_.app->of<Canvas>().free_area());
  EXPECT_EQ(video, "video," + std::to_string(size.width) + "," + std::to_string(size.height) + ",3");
  EXPECT_EQ(audio.substr(0, 5), sounds ? "audio" : "");
}

TEST_F(FilmDesk, APlayblastWithoutAProjectGoesWhereTheUserKeepsFilms) {
  key_twice();
  desk_.app->of<Playback>().loop() = {0.0, 1.0 / 24};
  without_ffmpeg([&] {
    desk_.app->of<Actions>().run(Action{"playblast"});
    ASSERT_TRUE(wait());
    EXPECT_EQ(said().text, "written: " + desk_.path("head-playblast/head-playblast0000.png") + " and on");
    fs::create_directories(desk_.path("Films here"));
    fs::create_directories(desk_.path(".config"));
    std::ofstream(desk_.path(".config/user-dirs.dirs")) << "# folders\nXDG_VIDEOS_DIR=\"$HOME/Films here\"\n";
    desk_.app->of<Actions>().run(Action{"playblast"});
    ASSERT_TRUE(wait());
  });
  EXPECT_EQ(files_in(desk_.path("Films here/head-playblast")), 2U);
}

TEST_F(FilmDesk, CancelGivesUpAndLeavesNothing) {
  desk_.click("Key");
  desk_.app->of<Playback>().go_to(400);
  desk_.click("Key");
  fs::create_directory(desk_.path("Videos"));
  without_ffmpeg([&] { desk_.app->of<Actions>().run(Action{"playblast"}); });
  ASSERT_TRUE(writer().writes());
  for (int i = 0; i < 6000 && writer().job()->progress().done < 2; ++i) {
    desk_.frames(1);
    ::usleep(10'000);
  }
  EXPECT_GE(writer().job()->progress().done, 2U);
  EXPECT_EQ(writer().job()->progress().all, 9601U);
  EXPECT_NE(desk_.interface->find("film progress"), nullptr);
  desk_.hit_escape();
  EXPECT_TRUE(writer().writes()) << "a key that closes things does not throw it away";
  desk_.click("Cancel##film progress");
  ASSERT_TRUE(wait());
  EXPECT_EQ(said().text.substr(0, 9), "cancelled");
  EXPECT_EQ(files_in(desk_.path("Videos")), 0U);
}

TEST_F(FilmDesk, ASoundThatIsGoneIsNamedAndTheFilmIsSilent) {
  if (!film::has_ffmpeg()) GTEST_SKIP() << "no ffmpeg";
  key_twice();
  ASSERT_TRUE(desk_.app->of<EditingSession>().perform(document::SetSound{desk_.path("gone.wav"), {}, 0}));
  desk_.frames();
  FilmEntry small;
  small.size = geometry::Viewport{64, 48};
  ASSERT_TRUE(writer().write(desk_.path("film.webm"), small));
  EXPECT_NE(said().text.find("gone.wav"), std::string::npos) << said().text;
  ASSERT_TRUE(wait());
  EXPECT_EQ(said().text, "written: " + desk_.path("film.webm"));
}

TEST_F(FilmDesk, WhatCannotBeWrittenIsSaid) {
  key_twice();
  FilmEntry entry;
  entry.kind = FilmKind::pictures;
  entry.size = geometry::Viewport{64, 48};
  std::ofstream(desk_.path("file")) << "no folder";
  ASSERT_TRUE(writer().write(desk_.path("file/film.png"), entry));
  ASSERT_TRUE(wait());
  EXPECT_TRUE(said().is_error);
  EXPECT_NE(said().text.find("folder"), std::string::npos) << said().text;
}

}  // namespace
}  // namespace penpose::app
