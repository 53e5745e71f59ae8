#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <sstream>

#include "core/base/edition.h"
#include "core/character/character.h"
#include "core/io/project/read_document.h"
#include "replay/session/session_player.h"
#include "replay/session/session_recorder.h"
#include "tests/support/models/sheet_model.h"
#include "tests/support/shared_data.h"

// Sessions that each edition recorded (tests/data/sessions/editions), drawn again with today's reading: heads posed by
// lines and by pens, controls sketched and drawn again, tools, joints, keys.

namespace penpose::replay {
namespace {

namespace fs = std::filesystem;

const fs::path k_folder = fs::path(PENPOSE_TEST_DATA) / "sessions" / "editions";

base::Result<document::Document> open_model(const std::string& path) {
  if (path == "test-sheet" || path == "sheet") return tests::open_sheet(path);
  auto made = character::Character::built_in(path);
  if (!made) return made.error();
  return made->document();
}

std::string text_of_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

base::Result<ReplayResult> play(const std::string& text, bool by_today, PlayerObserver* observer = nullptr) {
  PlayerOptions options;
  options.open = open_model;
  options.by_today = by_today;
  options.observer = observer;
  return play_session(read_from(base::as_bytes(text)), options);
}

/// What a session recorded: its steps, and how many of them have a state after them.
struct Recorded {
  std::size_t steps = 0;
  std::size_t states = 0;
  std::size_t strokes = 0;
};
Recorded recorded_in(const std::string& text) {
  Recorded out;
  std::istringstream lines(text);
  bool command = false;
  for (std::string line; std::getline(lines, line);) {
    const bool is_command =
        line.starts_with("# penpose do ") || line == "# penpose undo" || line == "# penpose redo";
    const bool is_state = line.starts_with("# penpose state ");
    out.steps += is_command || (is_state && !command) ? 1 : 0;
    out.strokes += is_state && !command ? 1 : 0;
    out.states += is_state ? 1 : 0;
    command = is_command;
  }
  return out;
}

std::vector<fs::path> sessions_of(std::uint32_t edition) {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(k_folder / std::to_string(edition))) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  return paths;
}

TEST(Editions, EachHasSessions) {
  for (std::uint32_t edition = 1; edition <= base::k_edition; ++edition) {
    ASSERT_TRUE(fs::is_directory(k_folder / std::to_string(edition)))
        << "keep sessions of the edition that ends: tests/data/sessions/editions";
    EXPECT_GE(sessions_of(edition).size(), 7U) << edition;
  }
}

TEST(Editions, OlderSessionsAreRefusedWithOneLineThatNamesTheRemedy) {
  for (std::uint32_t edition = 1; edition < base::k_edition; ++edition) {
    for (const fs::path& path : sessions_of(edition)) {
      const auto refused = play(text_of_file(path), false);
      ASSERT_FALSE(refused) << path;
      EXPECT_EQ(refused.error().place, "line 1");
      EXPECT_NE(refused.error().remedy.find("--by-today"), std::string::npos) << refused.error().line();
      EXPECT_EQ(refused.error().line().find('\n'), std::string::npos);
    }
  }
}

TEST(Editions, SessionsOfAllEditionsAreDrawnToTheirEndByToday) {
  for (std::uint32_t edition = 1; edition <= base::k_edition; ++edition) {
    for (const fs::path& path : sessions_of(edition)) {
      SCOPED_TRACE(path);
      const std::string text = text_of_file(path);
      const Recorded recorded = recorded_in(text);
      const auto drawn = play(text, true);
      ASSERT_TRUE(drawn) << drawn.error().line();
      ASSERT_TRUE(drawn->redrawn);
      const RedrawnSession& redrawn = *drawn->redrawn;
      EXPECT_EQ(redrawn.edition, edition);
      EXPECT_FALSE(redrawn.other_model) << "the model's state is known in the form in which it was written";
      EXPECT_TRUE(drawn->problems.empty());
      EXPECT_EQ(redrawn.steps.size(), recorded.steps);
      EXPECT_EQ(redrawn.strokes, recorded.strokes) << "every stroke is drawn";
      EXPECT_EQ(redrawn.count(CameOut::not_drawn), 0U);
      EXPECT_EQ(redrawn.count(CameOut::not_compared), recorded.steps - recorded.states);
      EXPECT_EQ(redrawn.count(CameOut::equal) + redrawn.count(CameOut::differently), recorded.states);
      for (const RedrawnStep& step : redrawn.steps) {
        EXPECT_EQ(text_of(step).empty(), step.came_out == CameOut::equal);
      }
      if (edition == base::k_edition) EXPECT_EQ(redrawn.count(CameOut::differently), 0U);
    }
  }
}

// What no later edition changed is equal to the bit: the forms in which states were written are known exactly.
TEST(Editions, StepsThatMeanTheSameTodayAreEqualToTheBit) {
  std::map<std::string, std::size_t> equal;
  for (std::uint32_t edition = 1; edition < base::k_edition; ++edition) {
    for (const fs::path& path : sessions_of(edition)) {
      const auto drawn = play(text_of_file(path), true);
      ASSERT_TRUE(drawn) << drawn.error().line();
      equal[path.stem().string()] += drawn->redrawn->count(CameOut::equal);
    }
  }
  for (const char* name : {"control", "random", "random_tools", "animate", "pose", "rig", "flat_lip", "penpartner"})
    EXPECT_GT(equal[name], 0U) << name;
}

TEST(Editions, WhatIsSavedIsASessionOfTodayThatReplaysToItsOwnStates) {
  for (std::uint32_t edition = 1; edition <= base::k_edition; ++edition) {
    for (const fs::path& path : sessions_of(edition)) {
      SCOPED_TRACE(path);
      std::string saved;
      SessionWriter writer(
          [&](std::string_view text, bool) -> base::Status {
            saved += text;
            return base::Done{};
          },
          "test");
      SessionRecorder recorder(writer);
      const auto drawn = play(text_of_file(path), true, &recorder);
      ASSERT_TRUE(drawn) << drawn.error().line();
      ASSERT_TRUE(writer.flush(false));
      EXPECT_TRUE(saved.starts_with("# penpose session edition=" + std::to_string(base::k_edition) + " program=test\n"));
      const auto again = play(saved, false);
      ASSERT_TRUE(again) << again.error().line();
      EXPECT_FALSE(again->divergence) << error_of(*again->divergence).line();
      EXPECT_GE(again->checked, drawn->redrawn->steps.size() - drawn->refused);
      EXPECT_EQ(again->session->editor().state(), drawn->session->editor().state());
    }
  }
}

// Lines that were drawn in the window, each undone before the next.
TEST(SharedEditions, WhatWasDrawnInTheWindowIsDrawnAgain) {
  if (!tests::has_shared()) GTEST_SKIP() << "no shared data";
  std::size_t sessions = 0;
  for (const auto& entry : fs::directory_iterator(tests::shared_dir() / "cases" / "window")) {
    if (entry.path().extension() != ".session") continue;
    SCOPED_TRACE(entry.path());
    ++sessions;
    const std::string text = text_of_file(entry.path());
    PlayerOptions options;
    options.open = [](const std::string& path) -> base::Result<document::Document> {
      if (path.starts_with("builtin:")) return open_model(path);
      return io::read_document(tests::read_file(tests::shared_dir() / "meshes" / path), path);
    };
    options.by_today = true;
    const auto drawn = play_session(read_from(base::as_bytes(text)), options);
    ASSERT_TRUE(drawn) << drawn.error().line();
    ASSERT_TRUE(drawn->redrawn);
    const Recorded recorded = recorded_in(text);
    EXPECT_GE(recorded.strokes, 42U);
    EXPECT_EQ(drawn->redrawn->strokes, recorded.strokes);
    EXPECT_EQ(drawn->redrawn->steps.size(), recorded.steps);
    EXPECT_EQ(drawn->redrawn->count(CameOut::not_compared), 0U);
    std::size_t undone = 0;
    for (const RedrawnStep& step : drawn->redrawn->steps) undone += step.what == "undo" ? 1 : 0;
    EXPECT_GE(undone, 28U);
  }
  EXPECT_GE(sessions, 2U);
}

}  // namespace
}  // namespace penpose::replay
