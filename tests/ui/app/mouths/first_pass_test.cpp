#include "ui/app/mouths/first_pass.h"

#include <chrono>
#include <fstream>
#include <gtest/gtest.h>
#include <thread>

#include "core/sound/read/read_sound.h"
#include "tests/support/app_desk.h"
#include "tests/support/sound_files.h"
#include "ui/app/dialogs/first_pass_entry.h"
#include "ui/app/mouths/kept_mouths.h"

namespace penpose::app {
namespace {

class FirstPassOfDesk : public ::testing::Test {
 protected:
  explicit FirstPassOfDesk() : desk_("first-pass") { desk_.begin(); }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(desk_.path(name), std::ios::binary) << text;
  }
  void lay_sound(const std::vector<float>& samples) {
    const auto bytes = tests::wav_bytes(samples, 8000);
    write("talk.wav", std::string(bytes.begin(), bytes.end()));
    desk_.app->of<SoundTrack>().open(desk_.path("talk.wav"));
    desk_.frames();
  }
  void keep_mouths() {
    desk_.app->of<KeptMouths>().keep_usual();
    desk_.frames();
  }
  void ask() {
    desk_.app->of<Dialogs>().show(Dialog{"first pass"});
    desk_.frames();
  }
  FirstPass& pass() { return desk_.app->of<FirstPass>(); }
  void wait() {
    for (int i = 0; i < 3000 && pass().listens(); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      desk_.frames(1);
    }
    desk_.frames();
  }

  Desk desk_;
};

TEST_F(FirstPassOfDesk, CuesBecomeKeysInOneStepWhereTheSoundBegins) {
  if (!sound::reads_sounds()) GTEST_SKIP() << "built without libsndfile";
  lay_sound(tests::tone(440, 8000, 2));
  desk_.app->of<SoundTrack>().move(1);
  keep_mouths();
  write("talk.tsv", "0.00\tX\n0.50\tD\n1.00\tA\n1.10\tD\n1.50\tX\n");
  ask();
  desk_.click("Cues of a file");
  desk_.click("talk.tsv");
  EXPECT_FALSE(desk_.app->of<Dialogs>().any());
  ASSERT_NE(desk_.document().spoken, nullptr);
  const auto jaw = rig::find_parameter(desk_.document().model->rig->parameters(), "jaw").value();
  EXPECT_GT(document::pose_at(desk_.document(), 1.8)[jaw], 0.4) << "open";
  EXPECT_EQ(document::pose_at(desk_.document(), 2.04)[jaw], 0) << "closed for m, b, p";
  desk_.app->of<Playback>().undo();
  EXPECT_EQ(desk_.document().spoken, nullptr);
  EXPECT_TRUE(desk_.document().timeline->keys.empty());
}

TEST_F(FirstPassOfDesk, AFileThatHasNoCuesIsToldInTheDialogByItsName) {
  keep_mouths();
  write("bad.tsv", "hello\n");
  ask();
  desk_.click("Cues of a file");
  desk_.click("bad.tsv");
  EXPECT_TRUE(desk_.app->of<Dialogs>().any());
  EXPECT_NE(desk_.app->of<Dialogs>().state<FirstPassEntry>().told.find("bad.tsv"), std::string::npos);
  EXPECT_TRUE(desk_.document().timeline->keys.empty());
}

TEST_F(FirstPassOfDesk, TheDialogOffersWhatIsMissing) {
  ask();
  EXPECT_EQ(desk_.interface->find("##said"), nullptr);
  desk_.click("Take those of the model's own controls");
  EXPECT_EQ(desk_.document().mouths.size(), 9U);
  desk_.click("Open a sound");
  EXPECT_EQ(desk_.app->of<Dialogs>().open(), Dialog::sound);
  EXPECT_FALSE(pass().listen("").ok());
}

TEST_F(FirstPassOfDesk, ASoundInWhichNobodySpeaksIsToldAndNothingIsKeyed) {
  if (!sound::reads_sounds() || !speech::can_hear()) GTEST_SKIP() << "nothing listens here";
  lay_sound(std::vector<float>(8000));
  keep_mouths();
  ask();
  desk_.click("By ear");
  desk_.click("Speak##now");
  wait();
  EXPECT_TRUE(desk_.app->of<Dialogs>().any()) << "it says why";
  EXPECT_NE(desk_.app->of<Dialogs>().state<FirstPassEntry>().told.find("nothing is spoken"), std::string::npos);
  EXPECT_TRUE(desk_.document().timeline->keys.empty());
}

TEST_F(FirstPassOfDesk, WhatIsStoppedKeysNothing) {
  if (!sound::reads_sounds() || !speech::can_hear()) GTEST_SKIP() << "nothing listens here";
  lay_sound(tests::tone(300, 8000, 60));
  keep_mouths();
  ask();
  desk_.click("By ear");
  desk_.click("Speak##now");
  ASSERT_TRUE(pass().listens());
  desk_.frames();
  EXPECT_NE(desk_.interface->find("listening"), nullptr);
  desk_.click("Stop##listening");
  EXPECT_FALSE(pass().listens());
  EXPECT_TRUE(desk_.app->of<Dialogs>().any()) << "to try another way";
  EXPECT_TRUE(pass().refused().empty());
  EXPECT_TRUE(desk_.document().timeline->keys.empty());
}

TEST_F(FirstPassOfDesk, TheTextIsOpenedFromAFileAndTyped) {
  if (!sound::reads_sounds() || !speech::can_hear()) GTEST_SKIP() << "nothing listens here";
  lay_sound(tests::tone(300, 8000, 1));
  keep_mouths();
  write("said.txt", "my baby\nputs big maps");
  ask();
  desk_.click("Open a text (.txt)");
  desk_.click("said.txt");
  const auto& entry = desk_.app->of<Dialogs>().state<FirstPassEntry>();
  EXPECT_EQ(entry.text, "my baby puts big maps") << "in lines as long as the field";
  desk_.click("##said");
  desk_.type(" too");
  EXPECT_NE(entry.text.find("too"), std::string::npos);
}

}  // namespace
}  // namespace penpose::app
