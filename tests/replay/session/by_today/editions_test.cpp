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
#include "tests/support/models/stick_figure.h"
#include "tests/support/random_session.h"
#include "tests/support/shared_data.h"

// Sessions that each edition recorded (tests/data/sessions/editions), drawn again with today's reading: heads posed by
// lines and by pens, controls sketched and drawn again, tools, joints, keys.

namespace penpose::replay {
namespace {

namespace fs = std::filesystem;

const fs::path k_folder = fs::path(PENPOSE_TEST_DATA) / "sessions" / "editions";

base::Result<document::Document> open_model(const std::string& path) {
  if (path == "test-sheet" || path == "sheet") return tests::open_sheet(path);
  static std::map<std::string, document::Document> opened;  // the head takes a while to model
  if (const auto known = opened.find(path); known != opened.end()) return known->second;
  auto made = character::Character::built_in(path);
  if (!made) return made.error();
  return opened.emplace(path, made->document()).first->second;
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
    const bool is_command = line.starts_with("# penpose do ") || line == "# penpose undo" || line == "# penpose redo";
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

class EachEdition : public testing::TestWithParam<std::uint32_t> {};
INSTANTIATE_TEST_SUITE_P(Editions, EachEdition, testing::Range(1U, base::k_edition + 1),
                         testing::PrintToStringParamName());

/// A session drawn by today, and what was written down meanwhile.
struct Drawn {
  base::Result<ReplayResult> result;
  std::string saved;
};
Drawn drawn_and_saved(const std::string& text) {
  std::string saved;
  SessionWriter writer(
      [&](std::string_view more, bool) -> base::Status {
        saved += more;
        return base::Done{};
      },
      "test");
  SessionRecorder recorder(writer);
  auto result = play(text, true, &recorder);
  EXPECT_TRUE(writer.flush(false));
  return {std::move(result), std::move(saved)};
}

TEST_P(EachEdition, SessionsAreDrawnToTheirEndAndSavedAsSessionsOfToday) {
  std::size_t equal = 0;
  for (const fs::path& path : sessions_of(GetParam())) {
    SCOPED_TRACE(path);
    const std::string text = text_of_file(path);
    const Recorded recorded = recorded_in(text);
    const auto [drawn, saved] = drawn_and_saved(text);
    ASSERT_TRUE(drawn) << drawn.error().line();
    ASSERT_TRUE(drawn->redrawn);
    EXPECT_TRUE(drawn->problems.empty());
    const RedrawnSession& redrawn = *drawn->redrawn;
    EXPECT_EQ(redrawn.edition, GetParam());
    EXPECT_FALSE(redrawn.other_model) << "the model's state is known in the form in which it was written";
    EXPECT_EQ(redrawn.steps.size(), recorded.steps);
    EXPECT_EQ(redrawn.strokes, recorded.strokes) << "every stroke is drawn";
    EXPECT_EQ(redrawn.count(CameOut::not_drawn), 0U);
    EXPECT_EQ(redrawn.count(CameOut::not_compared), recorded.steps - recorded.states);
    EXPECT_EQ(redrawn.count(CameOut::equal) + redrawn.count(CameOut::differently), recorded.states);
    for (const RedrawnStep& step : redrawn.steps) EXPECT_EQ(text_of(step).empty(), step.came_out == CameOut::equal);
    if (GetParam() == base::k_edition) {
      EXPECT_EQ(redrawn.count(CameOut::differently), 0U);
    }
    equal += redrawn.count(CameOut::equal);

    EXPECT_TRUE(saved.starts_with("# penpose session edition=" + std::to_string(base::k_edition) + " program=test\n"));
    const auto again = play(saved, false);
    ASSERT_TRUE(again) << again.error().line();
    EXPECT_FALSE(again->divergence) << error_of(*again->divergence).line();
    EXPECT_GE(again->checked, redrawn.steps.size() - drawn->refused);
    EXPECT_EQ(again->session->editor().state(), drawn->session->editor().state());
  }
  // What no later edition changed is equal to the bit: the forms in which states were written are known exactly.
  EXPECT_GE(equal, 15U);
}

// Any hand with all tools and commands, as the edition before would have recorded it: nothing that edition 7 changed.
TEST(Editions, WhatAnyHandDoesIsDrawnAgainStepByStep) {
  constexpr std::uint64_t k_seeds = 12;
  std::map<std::string, std::size_t> steps;
  for (std::uint64_t seed = 0; seed < k_seeds; ++seed) {
    SCOPED_TRACE(seed);
    tests::SessionScript script(document::make_document(tests::sheet_model()), "sheet");
    tests::RandomHand hand(script, seed);
    hand.run(60);
    std::string text = script.text();
    const std::string now = "edition=" + std::to_string(base::k_edition);
    text.replace(text.find(now), now.size(), "edition=6");
    const auto drawn = play(text, true);
    ASSERT_TRUE(drawn) << drawn.error().line();
    for (const RedrawnStep& step : drawn->redrawn->steps) {
      EXPECT_EQ(text_of(step), "");
      ++steps[step.what];
    }
    EXPECT_EQ(drawn->redrawn->steps.size(), recorded_in(text).steps);
    EXPECT_EQ(drawn->session->editor().state(), script.editor().state());
  }
  for (const char* what : {"stroke", "undo", "redo", "set_key", "move_keys", "lock_parameters", "begin_deformer"})
    EXPECT_GT(steps[what], 0U) << what;
}

// Joints: an arm that is drawn, as each edition since that of today's forms would have recorded it.
TEST(Editions, ALimbIsDrawnAgain) {
  tests::StickFigure figure;
  const std::size_t upper = figure.add(-1, {0, 0, 0}, {1, 0, 0}, 0.1);
  figure.add(static_cast<std::int32_t>(upper), {1, 0, 0}, {2, 0, 0}, 0.1);
  const auto rig = figure.rig();
  const auto made = document::make_model({rig, &rig->mesh()}, nullptr, figure.skeleton());
  ASSERT_TRUE(made) << made.error().line();
  tests::SessionScript script(document::make_document(*made), "arm");
  const document::View view{{{1, 0, 6}, {1, 0, 0}, {0, 1, 0}, 30}, {1000, 1000}};
  ASSERT_TRUE(script.act(ViewChanged{view}));
  const auto camera = geometry::Camera::make(view.camera, view.viewport).value();
  const auto line = [&](geometry::ModelPoint from, geometry::ModelPoint to) {
    std::vector<geometry::PxPoint> out;
    for (int i = 0; i <= 20; ++i) out.push_back(*camera.project(from + (to - from) * (i / 20.0)));
    return out;
  };
  ASSERT_TRUE(script.stroke(line({1.1, 0, 0}, {1.9, 0, 0})));
  ASSERT_TRUE(script.stroke(line({1.08, 0.1, 0}, {1.6, 0.7, 0})));
  ASSERT_TRUE(script.perform(document::SetKey{0, {}}));
  for (const char* edition : {"5", "6"}) {
    std::string text = script.text();
    const std::string now = "edition=" + std::to_string(base::k_edition);
    text.replace(text.find(now), now.size(), std::string("edition=") + edition);
    PlayerOptions options;
    options.open = [&](const std::string&) -> base::Result<document::Document> {
      return document::make_document(*made);
    };
    options.by_today = true;
    const auto drawn = play_session(read_from(base::as_bytes(text)), options);
    ASSERT_TRUE(drawn) << drawn.error().line();
    EXPECT_EQ(drawn->redrawn->strokes, 2U);
    EXPECT_EQ(drawn->redrawn->count(CameOut::equal), 3U) << summary_of(*drawn->redrawn);
    EXPECT_NE(drawn->session->editor().document().pose, rig::rest_pose(*made->rig));
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
