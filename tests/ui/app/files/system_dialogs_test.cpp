#include <fstream>
#include <gtest/gtest.h>
#include <iterator>

#include "tests/support/app_desk.h"
#include "ui/files/load_model.h"
#include "ui/files/save_model.h"

// The system's dialogs of files in place of ours, by a portal that answers as the test says.

namespace penpose::app {
namespace {

using portal::FileAnswer;
using Kind = FileAnswer::Kind;

/// What was asked, and what is answered.
struct Script {
  std::vector<portal::FileQuestion> asked;
  FileAnswer answer;
};

class ScriptedPortal : public portal::FilePortal {
 public:
  explicit ScriptedPortal(Script& script) : script_(script) {}
  void ask(const portal::FileQuestion& question) override { script_.asked.push_back(question); }
  FileAnswer take() override { return std::exchange(script_.answer, {}); }

 private:
  Script& script_;
};

struct PortalDesk : Desk {
  explicit PortalDesk(const std::string& name) : Desk(name) {
    begin();
    app->of<SystemDialogs>().set_portal(std::make_unique<ScriptedPortal>(script), [] { return "x11:7"; });
  }
  ~PortalDesk() { app->of<SystemDialogs>().set_portal(nullptr); }
  PortalDesk(const PortalDesk&) = delete;
  PortalDesk& operator=(const PortalDesk&) = delete;
  void answer(Kind kind, const std::string& file = {}) {
    script.answer = {kind, file};
    frames();
  }
  [[nodiscard]] Dialog shown() const { return app->of<Dialogs>().open(); }
  Script script;
};

void put_model(const Desk& desk, const std::string& name) {
  const auto model = files::load_model("builtin:demo");
  ASSERT_TRUE(model.ok() && files::save_model(*model, desk.path(name), files::SaveNotes::quiet).ok());
}

TEST(SystemDialogs, AFileIsOpenedAndMeanwhileTheWindowGoesOn) {
  PortalDesk desk("portal-open");
  put_model(desk, "mine.glb");
  desk.press('o', true);
  ASSERT_EQ(desk.script.asked.size(), 1U);
  EXPECT_EQ(desk.script.asked[0].parent, "x11:7");
  EXPECT_EQ(desk.script.asked[0].folder, desk.folder.string());
  EXPECT_FALSE(desk.script.asked[0].saves);
  EXPECT_EQ(desk.shown(), Dialog::none) << "ours is not shown";
  desk.press('o', true);
  desk.press('s', true);
  EXPECT_EQ(desk.script.asked.size(), 1U) << "one at a time";
  EXPECT_EQ(desk.shown(), Dialog::none);
  desk.press('m');
  EXPECT_TRUE(desk.app->of<Playback>().while_drawing().mirrors) << "the window goes on";
  desk.answer(Kind::chosen, desk.path("mine.glb"));
  EXPECT_EQ(desk.app->of<Files>().path(), desk.path("mine.glb"));
  desk.press('o', true);
  EXPECT_EQ(desk.script.asked.size(), 2U);
}

TEST(SystemDialogs, AProjectIsSavedUnderTheNameThatIsChosen) {
  PortalDesk desk("portal-save");
  desk.press('s', true);
  ASSERT_EQ(desk.script.asked.size(), 1U);
  EXPECT_TRUE(desk.script.asked[0].saves);
  EXPECT_EQ(desk.script.asked[0].name, "head.glb");
  desk.answer(Kind::chosen, desk.path("shot"));
  EXPECT_TRUE(std::filesystem::exists(desk.path("shot.glb")));
  EXPECT_EQ(desk.app->of<Files>().project(), desk.path("shot.glb"));
}

TEST(SystemDialogs, WhatTheSystemDidNotAskAboutIsAskedInOurs) {
  PortalDesk desk("portal-over");
  put_model(desk, "shot.glb");
  const auto size = std::filesystem::file_size(desk.path("shot.glb"));
  desk.press('s', true);
  desk.answer(Kind::chosen, desk.path("shot"));
  EXPECT_EQ(desk.shown(), Dialog::save) << "the ending makes it another file, which is there";
  EXPECT_EQ(std::filesystem::file_size(desk.path("shot.glb")), size);
  desk.click("Save##now");
  EXPECT_NE(desk.interface->find("Write over it##now"), nullptr);
  EXPECT_EQ(std::filesystem::file_size(desk.path("shot.glb")), size);
}

TEST(SystemDialogs, CancellingGivesUpWhatWaitedForTheSaving) {
  PortalDesk desk("portal-cancel");
  pose_mouth(desk);
  desk.press('q', true);
  ASSERT_EQ(desk.shown(), Dialog::unsaved);
  desk.click("Save first");
  ASSERT_EQ(desk.script.asked.size(), 1U);
  EXPECT_EQ(desk.shown(), Dialog::none);
  desk.answer(Kind::cancelled);
  EXPECT_EQ(desk.shown(), Dialog::none);
  EXPECT_FALSE(desk.app->of<Leaving>().wants_quit());
  desk.press('s', true);
  desk.answer(Kind::chosen, desk.path("later.glb"));
  EXPECT_FALSE(desk.app->of<Leaving>().wants_quit()) << "saving later is no quitting";
  EXPECT_TRUE(std::filesystem::exists(desk.path("later.glb")));
}

TEST(SystemDialogs, SavingFirstQuitsThen) {
  PortalDesk desk("portal-quit");
  pose_mouth(desk);
  desk.press('q', true);
  desk.click("Save first");
  desk.answer(Kind::chosen, desk.path("done.glb"));
  EXPECT_TRUE(desk.app->of<Leaving>().wants_quit());
}

TEST(SystemDialogs, WhereNoneAnswersOursIsShownWithoutAWord) {
  PortalDesk desk("portal-none");
  for (const auto& [action, dialog] : {std::pair{Action::open, Dialog::open}, std::pair{Action::save_as, Dialog::save},
                                       std::pair{Action::export_as, Dialog::export_as}}) {
    desk.app->of<Actions>().run(action);
    desk.frames();
    EXPECT_EQ(desk.shown(), Dialog::none);
    desk.answer(Kind::unavailable);
    EXPECT_EQ(desk.shown(), dialog);
    EXPECT_TRUE(desk.app->of<Notices>().all().empty());
    desk.hit_escape();
    EXPECT_EQ(desk.shown(), Dialog::none);
  }
}

TEST(SystemDialogs, ThePreferencesChooseOurs) {
  PortalDesk desk("portal-preference");
  desk.press(',', true);
  desk.click("Folders##tab");
  desk.click("penpose's own##files");
  EXPECT_FALSE(load_settings(desk.path("config")).system_dialogs);
  desk.click("Done");
  desk.press('o', true);
  EXPECT_EQ(desk.shown(), Dialog::open);
  EXPECT_TRUE(desk.script.asked.empty());
}

}  // namespace
}  // namespace penpose::app
