#include "ui/files/append_file.h"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "replay/session/session_player.h"
#include "tests/support/command_run.h"
#include "tests/support/killed.h"
#include "tests/support/random_session.h"

namespace penpose::files {
namespace {

class AppendFileTest : public tests::CommandRun {};

TEST_F(AppendFileTest, HoldsEveryPieceAtOnce) {
  auto file = AppendFile::create(path("a.hid"), "one\n");
  ASSERT_TRUE(file);
  EXPECT_EQ(content("a.hid"), "one\n");
  ASSERT_TRUE(file->append("two\n"));
  EXPECT_EQ(content("a.hid"), "one\ntwo\n") << "before it is closed";
  EXPECT_TRUE(file->flush());
  EXPECT_EQ(files(), 1u);
}

TEST_F(AppendFileTest, AnOlderFileIsNotReplaced) {
  save("a.hid", std::string("an older recording"));
  const auto file = AppendFile::create(path("a.hid"), "new\n");
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().what, "exists already and is not written over");
  EXPECT_EQ(content("a.hid"), "an older recording");
}

TEST_F(AppendFileTest, AFolderThatIsNotThereIsAnError) {
  const auto file = AppendFile::create(path("none/a.hid"), "x");
  ASSERT_FALSE(file);
  EXPECT_NE(file.error().line().find("cannot be written (No such file or directory)"), std::string::npos);
}

TEST_F(AppendFileTest, WhatIsNoFileIsWrittenToAndNotReplaced) {
  EXPECT_TRUE(AppendFile::create("/dev/null", "x"));
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  EXPECT_FALSE(AppendFile::create("/dev/full", "x")) << "as a full disk";
}

std::string temporary(const std::string& name) {
  return (std::filesystem::temp_directory_path() / ("penpose-" + std::to_string(::getpid()) + "-" + name)).string();
}

std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TEST(AppendFile, NeverWritesOverWhatIsThere) {
  const std::string path = temporary("there");
  std::ofstream(path) << "drawn yesterday";
  const auto file = AppendFile::create_new(path);
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().what, "exists already and is not written over");
  EXPECT_EQ(content_of(path), "drawn yesterday");
  std::filesystem::remove(path);
}

TEST(AppendFile, SaysThatAFolderCannotBeWritten) {
  const auto file = AppendFile::create_new("/proc/penpose.session");
  ASSERT_FALSE(file);
  EXPECT_NE(file.error().what.find("cannot be written"), std::string::npos);
}

TEST(AppendFile, AFullDiskIsAnErrorAndKeepsWhatWasWritten) {
  const std::string path = temporary("full");
  auto file = AppendFile::create_new(path);
  ASSERT_TRUE(file);
  // A file that may not grow beyond 4096 bytes, as on a disk with as much room.
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{4096, before.rlim_max};
  const auto ignore = std::signal(SIGXFSZ, SIG_IGN);
  ::setrlimit(RLIMIT_FSIZE, &small);
  EXPECT_TRUE(file->append(std::string(4000, 'a')));
  const auto status = file->append(std::string(4000, 'b'));
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, ignore);
  ASSERT_FALSE(status);
  EXPECT_NE(status.error().remedy.find("free space"), std::string::npos);
  EXPECT_EQ(content_of(path).substr(0, 4000), std::string(4000, 'a'));
  std::filesystem::remove(path);
}

// What a replay takes for whole stays, and nothing that it did not read.
TEST(AppendFile, GoesOnAfterWhatAReplayReads) {
  const std::string path = temporary("go-on");
  const auto gone_on = [&](const std::string& text) {
    std::ofstream(path, std::ios::binary | std::ios::trunc) << text;
    auto file = AppendFile::go_on(path);
    EXPECT_TRUE(file && file->append("# next\n"));
    return content_of(path);
  };
  EXPECT_EQ(gone_on("E: 0.1 2 01 02\n"), "E: 0.1 2 01 02\n# next\n");
  EXPECT_EQ(gone_on("# a\nE: 0.1 2 01 02"), "# a\nE: 0.1 2 01 02\n# next\n") << "all bytes of the report are there";
  EXPECT_EQ(gone_on("# a\nE: 0.1 2 01 0"), "# a\n# next\n");
  EXPECT_EQ(gone_on("# a\n# penpose undo"), "# a\n# next\n");
  EXPECT_EQ(gone_on(std::string(600000, 'x')), "# next\n");
  EXPECT_EQ(gone_on(""), "# next\n");
  std::filesystem::remove(path);
  EXPECT_FALSE(AppendFile::go_on(path));
}

/// Draws until it is killed, and tells through a pipe how many strokes have ended.
[[noreturn]] void draw_for_ever(const std::string& path, int pipe, std::uint64_t seed) {
  auto file = AppendFile::create_new(path);
  if (!file) ::_exit(1);
  replay::SessionWriter writer([&](std::string_view text, bool sync) { return file->append(text, sync); }, "test");
  replay::LiveSession live(document::make_document(tests::sheet_model()), &writer, "sheet");
  live.connect(0, replay::virtual_pen_identity());
  tests::SplitMix random(seed);
  std::int64_t time_us = 0;
  for (;;) {
    const double height = random.real(200, 800);
    const auto send = [&](double x, bool tip, bool in_range) {
      time_us += 3333;
      const auto viewport = live.session().editor().view().viewport;
      live.report(0, time_us, replay::virtual_pen_report({{x, height}, 0.5, in_range, tip, false, false}, viewport));
    };
    for (int i = 0; i <= 20; ++i) send(300 + 20 * i, true, true);
    send(700, false, true);
    const char one = 1;
    if (::write(pipe, &one, 1) != 1) ::_exit(1);
    if (live.session().stroke_count() % 6 == 0) {
      static_cast<void>(live.act(replay::Performed{document::ClearCurves{}}, time_us));
    }
  }
}

// The promise to the artist: a stroke that had ended is never lost, whenever the program dies.
TEST(AppendFile, NoStrokeThatHadEndedIsLostWhenTheProgramIsKilled) {
  const std::string path = temporary("killed");
  tests::SplitMix random(5);
  std::size_t most = 0;
  for (int round = 0; round < 200; ++round) {
    std::filesystem::remove(path);
    std::size_t ended = 0;
    tests::told_until_killed(
        static_cast<useconds_t>(random.below(60000)),
        [&](int pipe) { draw_for_ever(path, pipe, static_cast<std::uint64_t>(round)); }, ended);
    if (testing::Test::HasFatalFailure()) return;

    const std::string text = content_of(path);
    replay::PlayerOptions options;
    options.open = [](const std::string&) {
      return base::Result<document::Document>(document::make_document(tests::sheet_model()));
    };
    const auto played = replay::play_session(replay::read_from(base::as_bytes(text)), options);
    ASSERT_TRUE(played) << played.error().line();
    EXPECT_FALSE(played->divergence) << "round " << round;
    const std::size_t kept = played->session ? played->session->stroke_count() : 0;
    EXPECT_GE(kept, ended) << "round " << round;
    most = std::max(most, ended);
  }
  EXPECT_GT(most, 2U) << "the program was killed before it had drawn anything";
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace penpose::files
