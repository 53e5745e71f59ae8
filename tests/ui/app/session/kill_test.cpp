#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/document/document_hash.h"
#include "core/io/model/write_model.h"
#include "replay/session/session_player.h"
#include "tests/support/app_desk.h"
#include "tests/support/app_replay.h"
#include "tests/support/killed.h"
#include "tests/support/random_session.h"
#include "ui/app/files/session_files.h"
#include "ui/files/files.h"
#include "ui/files/load_model.h"

namespace penpose::app {
namespace {

/// Draws until it is killed, and tells through a pipe how many strokes have ended.
[[noreturn]] void draw_for_ever(Desk& desk, const std::string& model, int pipe, std::uint64_t seed) {
  if (!desk.app->of<Files>().open(model)) ::_exit(1);
  tests::SplitMix random(seed);
  const auto viewport = desk.app->of<Canvas>().view().viewport;
  for (int i = 0;; ++i) {
    const double y = viewport.height * random.real(0.35, 0.65);
    desk.app->of<Pointer>().moved({viewport.width * 0.4, y});
    desk.app->of<Pointer>().button(MouseButton::left, true, {viewport.width * 0.4, y});
    for (int k = 1; k <= 20; ++k) {
      desk.now_us += 3333;
      desk.app->of<Pointer>().moved({viewport.width * (0.4 + 0.01 * k), y});
    }
    desk.app->of<Pointer>().button(MouseButton::left, false, {viewport.width * 0.6, y});
    const char one = 1;
    if (::write(pipe, &one, 1) != 1) ::_exit(1);
    if (i % 3 == 2) desk.app->of<Actions>().run(Action::undo);
    if (i % 5 == 0) desk.app->of<Actions>().run(Action::key_pose);
  }
}

// A disk without room stops neither the work nor, when there is room again, the recording.
TEST(Kill, ADiskThatIsFullForAWhileLosesNothing) {
  const std::filesystem::path folder = Desk::folder_of("full_disk");
  std::filesystem::create_directories(folder);
  const std::string model = (folder / "sheet.glb").string();
  ASSERT_TRUE(files::write_file(model, io::write_glb(tests::sheet_model()).value()));
  Desk desk("full_disk", model, false);
  desk.begin();
  desk.click("Pose");
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit full{std::filesystem::file_size(desk.app->of<Recording>().path()) + 100, before.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &full), 0);
  const auto viewport = desk.app->of<Canvas>().view().viewport;
  const auto draw = [&](int i) {
    const double y = viewport.height * (0.4 + 0.05 * i);
    desk.app->of<Pointer>().button(MouseButton::left, true, {viewport.width * 0.4, y});
    for (int k = 1; k <= 20; ++k) {
      desk.now_us += 3333;
      desk.app->of<Pointer>().moved({viewport.width * (0.4 + 0.01 * k), y});
    }
    desk.app->of<Pointer>().button(MouseButton::left, false, {viewport.width * 0.6, y});
    desk.frames(2);
  };
  for (int i = 0; i < 4; ++i) draw(i);
  EXPECT_FALSE(desk.app->of<Recording>().records());
  EXPECT_TRUE(desk.says("cannot be written now"));
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
  const std::size_t drawn = desk.document().curves.size();
  EXPECT_GE(drawn, 1U);
  draw(5);
  EXPECT_TRUE(desk.app->of<Recording>().records());
  EXPECT_TRUE(desk.says("recording again"));
  const auto played = replayed(desk.app->of<Recording>().path());
  ASSERT_TRUE(played && played->session) << played.error().line();
  EXPECT_FALSE(played->divergence);
  EXPECT_EQ(document::DocumentHasher()(played->session->editor().document()).whole,
            document::DocumentHasher()(desk.document()).whole);
}

// The promise to the artist, kept by the app itself: whenever it dies, it offers the work again, and no stroke that had
// ended is missing.
TEST(Kill, NoStrokeThatHadEndedIsLostWhenTheAppIsKilled) {
  const std::filesystem::path folder = Desk::folder_of("killed");
  std::filesystem::create_directories(folder);
  const std::string model = (folder / "sheet.glb").string();
  ASSERT_TRUE(files::write_file(model, io::write_glb(tests::sheet_model()).value()));
  const std::string sessions = (folder / "state" / "sessions").string();
  tests::SplitMix random(11);
  std::size_t most = 0;
  Desk desk("killed", model, false);
  desk.begin();
  desk.click("Pose");
  const char* wanted = std::getenv("PENPOSE_KILLS");
  const int rounds = wanted == nullptr ? 200 : std::atoi(wanted);
  for (int round = 0; round < rounds; ++round) {
    for (const std::string& path : past_sessions(sessions)) {
      if (path != desk.app->of<Recording>().path()) std::filesystem::remove(path);
    }
    std::size_t ended = 0;
    tests::told_until_killed(
        static_cast<useconds_t>(random.below(120000)),
        [&](int pipe) { draw_for_ever(desk, model, pipe, static_cast<std::uint64_t>(round)); }, ended);
    if (testing::Test::HasFatalFailure()) return;
    most = std::max(most, ended);

    const auto offered = abandoned_sessions(sessions);
    if (ended == 0 && offered.empty()) continue;
    ASSERT_EQ(offered.size(), 1U) << "round " << round;
    std::ifstream file(offered.front(), std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    replay::PlayerOptions options;
    options.open = [](const std::string& path) { return files::load_document(path); };
    const auto played = replay::play_session(replay::read_from(base::as_bytes(text)), options);
    ASSERT_TRUE(played) << played.error().line();
    EXPECT_FALSE(played->divergence) << "round " << round;
    ASSERT_TRUE(played->session);
    EXPECT_GE(played->session->stroke_count(), ended) << "round " << round;
    settle_session(offered.front());
  }
  EXPECT_GT(most, 2U) << "the app was killed before it had drawn anything";
}

}  // namespace
}  // namespace penpose::app
