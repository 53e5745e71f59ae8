#include <fstream>
#include <gtest/gtest.h>
#include <iterator>

#include "core/base/edition.h"
#include "tests/support/app_desk.h"
#include "ui/files/load_model.h"
#include "ui/files/session_model.h"

// A session of an older edition in the window: it is asked about once, drawn again, and gone on with as one of today.

namespace penpose::app {
namespace {

std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A session that an older edition recorded, in the desk's folder.
std::string older_session(const Desk& desk, const std::string& name, int edition) {
  const std::string path = desk.path("old.session");
  std::filesystem::copy_file(std::filesystem::path(PENPOSE_TEST_DATA) / "sessions" / "editions" /
                                 std::to_string(edition) / (name + ".session"),
                             path);
  return path;
}

void press_open(Desk& desk, const std::string& path) {
  desk.app->of<Leaving>().ask_to_open(path);
  desk.frames();
}

TEST(OlderSession, IsAskedAboutAndDrawnAgainIntoASessionOfToday) {
  Desk desk("older-open");
  desk.begin();
  const std::string path = older_session(desk, "pose", 3);
  const std::string before = content_of(path);
  const std::string recorded = desk.app->of<Recording>().path();
  press_open(desk, path);
  ASSERT_EQ(desk.app->of<Dialogs>().open(), Dialog::older_session);
  EXPECT_EQ(desk.app->of<Dialogs>().state<OlderSession>().edition, 3U);
  EXPECT_TRUE(desk.document().curves.empty()) << "nothing is drawn before the answer";
  desk.click("Draw it again");
  ASSERT_EQ(desk.app->of<Dialogs>().open(), Dialog::drawn_again);
  const auto& report = desk.app->of<Dialogs>().state<DrawnAgain>().redrawn;
  EXPECT_EQ(report.edition, 3U);
  EXPECT_EQ(report.steps.size(), 6U);
  EXPECT_EQ(report.count(replay::CameOut::not_drawn), 0U);
  desk.click("Close");
  EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::none);
  EXPECT_EQ(desk.document().curves.size(), 3U);
  EXPECT_TRUE(desk.app->of<EditingSession>().unsaved());
  EXPECT_EQ(content_of(path), before) << "the session itself stays as it is";
  // What goes on is a session of today with all that was drawn, and undo goes back into it.
  const std::string session = desk.app->of<Recording>().path();
  EXPECT_NE(session, recorded);
  EXPECT_NE(session, path);
  desk.click("Key");
  desk.press('z', true);
  desk.press('z', true);
  EXPECT_FALSE(desk.document().curves.back()->target.has_value());
  replay::PlayerOptions options;
  options.open = [&](const std::string& named) {
    return files::load_document(files::find_session_model(session, named));
  };
  const std::string text = content_of(session);
  EXPECT_TRUE(text.starts_with("# penpose session edition=" + std::to_string(base::k_edition) + " "));
  const auto played = replay::play_session(replay::read_from(base::as_bytes(text)), options);
  ASSERT_TRUE(played) << played.error().line();
  EXPECT_FALSE(played->divergence);
  EXPECT_EQ(played->session->editor().state(), desk.app->of<EditingSession>().state());
}

TEST(OlderSession, CancelLeavesEverythingAsItIs) {
  Desk desk("older-cancel");
  desk.begin();
  pose_mouth(desk);
  const auto state = desk.app->of<EditingSession>().state();
  const std::string session = desk.app->of<Recording>().path();
  const std::string path = older_session(desk, "pose", 5);
  desk.app->of<Files>().try_open(path);
  desk.frames();
  desk.click("Cancel");
  EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::none);
  EXPECT_EQ(desk.app->of<EditingSession>().state(), state);
  EXPECT_EQ(desk.app->of<Recording>().path(), session);
}

TEST(OlderSession, OneThatCannotBeDrawnIsSaidAndTheWorkGoesOn) {
  Desk desk("older-broken");
  desk.begin();
  pose_mouth(desk);
  const auto state = desk.app->of<EditingSession>().state();
  const std::string session = desk.app->of<Recording>().path();
  const std::string path = older_session(desk, "pose", 5);
  std::string text = content_of(path);
  text.replace(text.find("builtin%3Ademo"), 14, "gone.glb");
  std::ofstream(path, std::ios::binary) << text;
  press_open(desk, path);
  if (desk.app->of<Dialogs>().open() == Dialog::unsaved) desk.click("Open without saving");
  ASSERT_EQ(desk.app->of<Dialogs>().open(), Dialog::older_session);
  desk.click("Draw it again");
  EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::none);
  EXPECT_TRUE(desk.app->of<Notices>().all().back().is_error);
  EXPECT_NE(desk.app->of<Notices>().all().back().text.find("gone.glb"), std::string::npos);
  EXPECT_EQ(desk.app->of<EditingSession>().state(), state);
  EXPECT_EQ(desk.app->of<Recording>().path(), session);
  desk.click("Key");
  EXPECT_EQ(desk.document().timeline->keys.size(), 1U);
  EXPECT_NE(content_of(session).find("do set_key"), std::string::npos) << "it is still recorded";
}

TEST(OlderSession, OneOfTodayAndOneOfANewerEditionAreNotAskedAbout) {
  Desk desk("older-not");
  desk.begin();
  const std::string path = older_session(desk, "pose", 6);
  const auto of_edition = [&](std::uint32_t edition) {
    std::string text = content_of(path);
    const std::size_t at = text.find("edition=") + 8;
    text.replace(at, text.find(' ', at) - at, std::to_string(edition));
    const std::string other = desk.path("other.session");
    std::ofstream(other, std::ios::binary | std::ios::trunc) << text;
    return other;
  };
  desk.app->of<Files>().try_open(of_edition(base::k_edition + 1));
  EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::none);
  EXPECT_TRUE(desk.app->of<Notices>().all().back().is_error);
  desk.app->of<Files>().try_open(of_edition(base::k_edition));
  EXPECT_EQ(desk.app->of<Dialogs>().open(), Dialog::none);
  EXPECT_EQ(desk.document().curves.size(), 3U);
}

}  // namespace
}  // namespace penpose::app
