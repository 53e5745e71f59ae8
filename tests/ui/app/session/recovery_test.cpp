#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <set>
#include <sstream>

#include "core/sound/read/read_sound.h"
#include "replay/session/session_player.h"
#include "tests/support/app_desk.h"
#include "tests/support/sound_files.h"
#include "ui/files/load_model.h"

// What a crash leaves, and how one goes on from there.

namespace penpose::app {
namespace {

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The program dies: its session stays as it is, with the note beside it, and nothing is finished.
std::string crash(std::unique_ptr<Desk> desk) {
  const std::string session = desk->app->of<Recording>().path();
  const std::string note = text_of(session + ".open");
  const std::string text = text_of(session);
  desk.reset();
  std::ofstream(session, std::ios::binary) << text;
  std::ofstream(session + ".open") << note;
  return session;
}

std::unique_ptr<Desk> start(const std::string& name, bool fresh = false) {
  auto desk = std::make_unique<Desk>(name, "builtin:demo", fresh);
  if (fresh) desk->begin();
  return desk;
}

TEST(Recovery, AfterACrashTheWorkComesBackWithItsStepsAndIsOfferedAgainAfterTheNext) {
  auto desk = start("crash", true);
  pose_mouth(*desk);
  const auto lost = desk->app->of<EditingSession>().state();
  const std::string session = crash(std::move(desk));
  desk = start("crash");
  ASSERT_EQ(desk->app->of<Dialogs>().open(), Dialog::recover);
  desk->click("Bring it back");
  EXPECT_EQ(desk->app->of<EditingSession>().state(), lost);
  EXPECT_TRUE(desk->app->of<EditingSession>().unsaved()) << "quitting asks";
  EXPECT_TRUE(abandoned_sessions(desk->path("state/sessions")).empty()) << "another window does not offer it";
  // Undo goes back beyond the crash, and the same file goes on.
  EXPECT_EQ(desk->app->of<Recording>().path(), session);
  desk->press('z', true);
  EXPECT_FALSE(desk->document().curves.front()->target.has_value());
  desk->press('z', true, true);
  EXPECT_EQ(desk->app->of<EditingSession>().state(), lost);
  // The next crash comes before anything else is done.
  crash(std::move(desk));
  desk = start("crash");
  ASSERT_EQ(desk->app->of<Dialogs>().open(), Dialog::recover);
  desk->click("Bring it back");
  EXPECT_EQ(desk->app->of<EditingSession>().state(), lost);
  // And one after more work.
  desk->click("Key");
  const auto later = desk->app->of<EditingSession>().state();
  crash(std::move(desk));
  desk = start("crash");
  ASSERT_EQ(desk->app->of<Dialogs>().open(), Dialog::recover);
  desk->click("Bring it back");
  EXPECT_EQ(desk->app->of<EditingSession>().state(), later);
  EXPECT_EQ(desk->app->of<EditingSession>().editor().history().undo_count(), 3U);
}

TEST(Recovery, SaveGoesWhereTheWorkWasSavedBeforeTheCrash) {
  auto desk = start("crash-project", true);
  pose_mouth(*desk);
  const std::string project = desk->path("mine.glb");
  ASSERT_TRUE(desk->app->of<Files>().save(project).ok());
  // Nothing is lost when everything was saved.
  crash(std::move(desk));
  desk = start("crash-project");
  EXPECT_NE(desk->app->of<Dialogs>().open(), Dialog::recover);
  // The project is opened, saved over itself, and gone on with.
  ASSERT_TRUE(desk->app->of<Files>().open(project).ok());
  desk->frames();
  desk->click("Key");
  desk->press('s', true);
  EXPECT_FALSE(desk->app->of<EditingSession>().unsaved());
  desk->app->of<Controls>().set_parameter(0, desk->document().model->rig->parameters()[0].maximum);
  const auto lost = desk->app->of<EditingSession>().state();
  crash(std::move(desk));
  desk = start("crash-project");
  ASSERT_EQ(desk->app->of<Dialogs>().open(), Dialog::recover);
  desk->click("Bring it back");
  EXPECT_EQ(desk->app->of<EditingSession>().state(), lost) << "though the file that it began on was written over";
  EXPECT_EQ(desk->app->of<Files>().project(), project);
  desk->press('s', true);
  EXPECT_EQ(desk->app->of<Dialogs>().open(), Dialog::none) << "no name is asked for";
  EXPECT_FALSE(desk->app->of<EditingSession>().unsaved());
}

TEST(Recovery, MovesInTimeAfterTheSaveLeaveNothingToSaveOrToBringBack) {
  auto desk = start("crash-scrub", true);
  desk->click("Key");
  desk->app->of<Playback>().go_to(2);
  desk->app->of<Controls>().set_parameter(0, desk->document().model->rig->parameters()[0].maximum);
  desk->click("Key");
  ASSERT_TRUE(desk->app->of<Files>().save(desk->path("mine.glb")).ok());
  const auto pose = desk->document().pose;
  desk->app->of<Playback>().go_to(1);
  desk->press(',');
  desk->press('.', false, true);
  desk->frames();
  EXPECT_NE(desk->document().pose, pose) << "the face is that of the other moment";
  EXPECT_FALSE(desk->app->of<EditingSession>().unsaved());
  crash(std::move(desk));
  desk = start("crash-scrub");
  EXPECT_NE(desk->app->of<Dialogs>().open(), Dialog::recover);
  // A change counts, also between two moves in time.
  ASSERT_TRUE(desk->app->of<Files>().open(desk->path("mine.glb")).ok());
  desk->app->of<Playback>().go_to(2);
  desk->app->of<Keys>().set_kind(document::KeyKind::linear);
  EXPECT_TRUE(desk->app->of<EditingSession>().unsaved());
  desk->app->of<Playback>().go_to(1);
  EXPECT_TRUE(desk->app->of<EditingSession>().unsaved());
}

TEST(Recovery, TheWordsOfASoundComeBackAsWords) {
  if (!sound::reads_sounds()) GTEST_SKIP() << "built without libsndfile";
  auto desk = start("crash-words", true);
  const auto bytes = tests::wav_bytes(tests::tone(440, 8000, 2), 8000);
  std::ofstream(desk->path("talk.wav"), std::ios::binary) << std::string(bytes.begin(), bytes.end());
  desk->app->of<SoundTrack>().open(desk->path("talk.wav"));
  desk->app->of<KeptMouths>().keep_usual();
  auto& editing = desk->app->of<EditingSession>();
  ASSERT_TRUE(editing.perform(document::KeyMouths{{0, 0.5, 1}, {"rest", "A", "rest"}}));
  ASSERT_TRUE(editing.perform_with(document::SetWords{{0.4, 1.2}, {"hello", "there"}}));
  desk->frames();
  ASSERT_NE(desk->interface->find("said hello"), nullptr);
  crash(std::move(desk));
  desk = start("crash-words");
  ASSERT_EQ(desk->app->of<Dialogs>().open(), Dialog::recover);
  desk->click("Bring it back");
  EXPECT_NE(desk->interface->find("said hello"), nullptr);
  EXPECT_NE(desk->interface->find("said there"), nullptr);
  EXPECT_EQ(desk->interface->find("said A"), nullptr) << "no name of a mouth";
  ASSERT_TRUE(desk->app->of<Files>().save(desk->path("talks.glb")).ok());
  ASSERT_TRUE(desk->app->of<Files>().open(desk->path("talks.glb")).ok());
  desk->frames();
  EXPECT_NE(desk->interface->find("said hello"), nullptr) << "the project keeps them";
}

TEST(Recovery, AStrokeThatTheCrashCutOffIsKeptAsFarAsItCame) {
  auto desk = start("crash-stroke", true);
  desk->stroke(desk->named_curve(any_curve(*desk)));
  desk->stroke(desk->named_curve(any_curve(*desk), {0, -14}), false);
  // Reports are handed over at the latest when the pen lifts; this is what a long stroke has handed over before.
  desk->app->of<Pointer>().button(MouseButton::left, false, {500, 400});
  const std::string session = crash(std::move(desk));
  std::string text = text_of(session);
  const std::size_t last = text.rfind("\nE:");
  std::ofstream(session, std::ios::binary) << text.substr(0, last + 12);
  desk = start("crash-stroke");
  ASSERT_EQ(desk->app->of<Dialogs>().open(), Dialog::recover);
  desk->click("Bring it back");
  ASSERT_EQ(desk->document().curves.size(), 1U);
  EXPECT_TRUE(desk->document().curves.front()->target.has_value());
  const auto state = desk->app->of<EditingSession>().state();
  crash(std::move(desk));
  desk = start("crash-stroke");
  desk->click("Bring it back");
  EXPECT_EQ(desk->app->of<EditingSession>().state(), state) << "the file that was mended replays";
}

// A power cut stops in the middle of a line, or right before its break: whatever came back goes on in a file that
// replays.
TEST(Recovery, WhereverTheFileWasCutOffItGoesOnAndReplays) {
  auto desk = start("crash-cut", true);
  pose_mouth(*desk);
  const std::string session = crash(std::move(desk));
  const std::string whole = text_of(session);
  const std::string note = text_of(session + ".open");
  const std::size_t lifted = whole.rfind("\nE:");
  const std::size_t lifted_end = whole.find('\n', lifted + 1);
  const std::size_t first_state = whole.find("# penpose state");
  std::set<std::size_t> cuts{lifted_end, lifted_end - 1, lifted_end + 1, whole.size() - 1, whole.size()};
  for (std::size_t at = whole.find('\n', first_state) + 1; at < whole.size(); at += 997) cuts.insert(at);
  for (const std::size_t cut : cuts) {
    desk.reset();
    std::filesystem::remove_all(Desk::folder_of("crash-cut"));
    std::filesystem::create_directories(std::filesystem::path(session).parent_path());
    std::ofstream(session, std::ios::binary) << whole.substr(0, cut);
    std::ofstream(session + ".open") << note;
    desk = start("crash-cut");
    ASSERT_EQ(desk->app->of<Dialogs>().open(), Dialog::recover) << "cut at byte " << cut;
    desk->click("Bring it back");
    desk->begin();
    desk->click("Key");
    const auto state = desk->app->of<EditingSession>().state();
    ASSERT_EQ(desk->document().timeline->keys.size(), 1U);
    const std::string text = text_of(session);
    replay::PlayerOptions options;
    options.open = [](const std::string& path) { return files::load_document(path); };
    const auto played = replay::play_session(replay::read_from(base::as_bytes(text)), options);
    ASSERT_TRUE(played) << played.error().line();
    EXPECT_FALSE(played->divergence) << "cut at byte " << cut << " of " << whole.size();
    EXPECT_EQ(played->session->editor().state(), state) << "cut at byte " << cut << " of " << whole.size();
  }
}

TEST(Recovery, WhatIsLeftForLaterIsOfferedAtTheNextStart) {
  auto desk = start("crash-later", true);
  pose_mouth(*desk);
  crash(std::move(desk));
  desk = start("crash-later");
  ASSERT_EQ(desk->app->of<Dialogs>().open(), Dialog::recover);
  desk->hit_escape();
  EXPECT_EQ(desk->app->of<Dialogs>().open(), Dialog::none);
  desk.reset();
  desk = start("crash-later");
  ASSERT_EQ(desk->app->of<Dialogs>().open(), Dialog::recover);
  desk->click("Start fresh");
  EXPECT_EQ(desk->app->of<Dialogs>().open(), Dialog::none);
  desk.reset();
  desk = start("crash-later");
  EXPECT_EQ(desk->app->of<Dialogs>().open(), Dialog::none);
}

TEST(Recovery, WorkThatASignalInterruptsIsOfferedAtTheNextStart) {
  document::DocumentState lost;
  {
    Desk desk("signal");
    desk.begin();
    pose_mouth(desk);
    desk.stroke(desk.named_curve("brow_L"), false);
    desk.app->of<Leaving>().quit_at_once();
    EXPECT_EQ(desk.document().curves.size(), 2U) << "the stroke under the pen is kept, too";
    lost = desk.app->of<EditingSession>().state();
    EXPECT_TRUE(desk.app->of<Leaving>().wants_quit()) << "nobody is asked";
  }
  Desk desk("signal", "builtin:demo", false);
  ASSERT_EQ(desk.app->of<Dialogs>().open(), Dialog::recover);
  desk.click("Bring it back");
  EXPECT_EQ(desk.app->of<EditingSession>().state().parts[3], lost.parts[3]);
}

}  // namespace
}  // namespace penpose::app
