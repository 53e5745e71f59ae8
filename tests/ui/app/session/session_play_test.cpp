#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <iterator>
#include <sstream>

#include "tests/support/app_desk.h"
#include "ui/files/load_model.h"
#include "ui/files/session_model.h"

// A recorded session played in the app, and what is wrong with one.

namespace penpose::app {
namespace {

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A session of two strokes and a key, as the app wrote it.
std::string recorded(const std::string& name) {
  Desk desk(name);
  desk.begin();
  pose_mouth(desk);
  desk.click("Key");
  return text_of(desk.app->of<Recording>().path());
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

struct Played {
  base::Status status{base::Done{}};
  std::optional<replay::Divergence> divergence;
  std::string said;
};

Played play(const std::string& name, const std::string& text) {
  Desk desk(name);
  desk.begin();
  const std::string path = desk.path("played.session");
  std::ofstream(path, std::ios::binary) << text;
  Played out;
  const auto before = desk.app->of<EditingSession>().state();
  out.status = desk.app->of<Files>().play_trace(path);
  if (!out.status) {
    EXPECT_EQ(desk.app->of<EditingSession>().state(), before) << "what is refused changes nothing";
    return out;
  }
  desk.app->of<Player>().trace->set_speed(16);
  for (int i = 0; i < 2000 && !desk.app->of<Player>().trace->finished(); ++i) {
    desk.frames(1);
    for (const Notice& notice : desk.app->of<Notices>().all()) {
      if (notice.is_error) out.said = notice.text;
    }
  }
  EXPECT_TRUE(desk.app->of<Player>().trace->finished());
  out.divergence = desk.app->of<Player>().trace->divergence();
  return out;
}

TEST(SessionPlay, WhatWasRecordedIsComeToAndNothingIsSaid) {
  const Played played = play("play-equal", recorded("play-recorded"));
  ASSERT_TRUE(played.status) << played.status.error().line();
  EXPECT_FALSE(played.divergence);
  EXPECT_EQ(played.said, "");
}

TEST(SessionPlay, AnotherEditionIsRefusedByItsProgramsName) {
  const Played played =
      play("play-version", replaced(recorded("play-recorded"), "penpose session edition=11", "penpose session 9"));
  ASSERT_FALSE(played.status);
  EXPECT_NE(played.status.error().what.find("another edition"), std::string::npos) << played.status.error().line();
  EXPECT_EQ(played.status.error().place, "line 1");
}

TEST(SessionPlay, AModelThatHasChangedOrIsNotNamedIsRefused) {
  const std::string text = recorded("play-recorded");
  const std::size_t model = text.find("# penpose model ");
  std::string other = text;
  other[model + 16] = other[model + 16] == '0' ? '1' : '0';
  const Played changed = play("play-model", other);
  ASSERT_FALSE(changed.status);
  EXPECT_NE(changed.status.error().what.find("is not the one that was drawn on"), std::string::npos);
  const Played unnamed = play("play-model", text.substr(0, model) + text.substr(text.find('\n', model) + 1));
  ASSERT_FALSE(unnamed.status);
  EXPECT_NE(unnamed.status.error().what.find("does not say what it was drawn on"), std::string::npos);
}

TEST(SessionPlay, ADivergenceIsToldWithItsLineAndWhatDiffers) {
  const std::string text = recorded("play-recorded");
  const Played played = play("play-differs", replaced(text, "# penpose do set_key", "# penpose do set_key time_s=3"));
  ASSERT_TRUE(played.status);
  ASSERT_TRUE(played.divergence);
  std::uint64_t line = 0;
  std::istringstream lines(text);
  for (std::string one; std::getline(lines, one) && !one.starts_with("# penpose do set_key");) ++line;
  EXPECT_EQ(played.divergence->line, line + 2) << "the state after the key";
  EXPECT_EQ(played.divergence->parts, (std::vector<std::string_view>{"parameters", "curves", "keys"}));
  EXPECT_NE(played.said.find("line " + std::to_string(line + 2)), std::string::npos) << played.said;
  EXPECT_NE(played.said.find("parameters, curves, keys"), std::string::npos) << played.said;
}

// The session began on a project that was then saved over: `penpose replay` and the app find the copy that was kept.
TEST(SessionPlay, ASessionReplaysAfterItsProjectWasSavedOverItself) {
  Desk desk("play-saved");
  desk.begin();
  const std::string project = desk.path("mine.glb");
  ASSERT_TRUE(desk.app->of<Files>().save(project).ok());
  std::filesystem::create_symlink("mine.glb", desk.path("link.glb"));
  for (const std::string& opened : {project, desk.path("link.glb")}) {
    ASSERT_TRUE(desk.app->of<Files>().open(opened).ok());
    desk.frames();
    pose_mouth(desk);
    ASSERT_TRUE(desk.app->of<Files>().save(project).ok());
    const auto state = desk.app->of<EditingSession>().state();
    const std::string session = desk.app->of<Recording>().path();
    replay::PlayerOptions options;
    options.open = [&](const std::string& named) {
      return files::load_document(files::find_session_model(session, named));
    };
    const std::string text = text_of(session);
    const auto played = replay::play_session(replay::read_from(base::as_bytes(text)), options);
    ASSERT_TRUE(played) << played.error().line();
    EXPECT_FALSE(played->divergence);
    EXPECT_EQ(played->session->editor().state(), state);
  }
}

TEST(SessionPlay, AProjectIsNotSavedOverWhereItsSessionCouldNotBeReplayedAnyMore) {
  Desk desk("play-full");
  desk.begin();
  const std::string project = desk.path("mine.glb");
  ASSERT_TRUE(desk.app->of<Files>().save(project).ok());
  ASSERT_TRUE(desk.app->of<Files>().open(project).ok());
  desk.frames();
  pose_mouth(desk);
  const std::string before = text_of(project);
  // No file of its name can be made there, as on a full disk: it is a link into a folder that is not there.
  std::filesystem::create_symlink("/none/model.glb", files::kept_model_of(desk.app->of<Recording>().path(), project));
  const auto saved = desk.app->of<Files>().save(project);
  ASSERT_FALSE(saved);
  EXPECT_NE(saved.error().line().find("save under another name"), std::string::npos) << saved.error().line();
  EXPECT_EQ(text_of(project), before);
  EXPECT_TRUE(desk.app->of<EditingSession>().unsaved());
  EXPECT_TRUE(desk.app->of<Files>().save(desk.path("other.glb")).ok());
}

}  // namespace
}  // namespace penpose::app
