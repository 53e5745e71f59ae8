#include <algorithm>
#include <gtest/gtest.h>

#include "core/document/document_hash.h"
#include "replay/session/session_player.h"
#include "tests/support/app_desk.h"
#include "tests/support/app_replay.h"
#include "ui/app/session/reading_offer.h"
#include "ui/app/view/outcome.h"
#include "ui/files/files.h"
#include "ui/files/load_model.h"

// "Did you mean": other readings of the last line, offered at the foot of the canvas.

namespace penpose::app {
namespace {

ReadingOffer& offer_of(const Desk& desk) { return desk.app->of<ReadingOffer>(); }
EditingSession& editing_of(const Desk& desk) { return desk.app->of<EditingSession>(); }

/// The mouth, and where it goes: its corners down by so many px, its middle by others.
void draw_mouth(Desk& desk, double corners, double in_the_middle) {
  const auto mouth = desk.named_curve("lip_upper_inner");
  auto smile = mouth;
  const double middle = 0.5 * (mouth.front().x + mouth.back().x);
  const double half = 0.5 * (mouth.back().x - mouth.front().x);
  for (PxPoint& p : smile) {
    const double x = (p.x - middle) / half;
    p.y += in_the_middle + (corners - in_the_middle) * x * x;
  }
  desk.stroke(mouth);
  desk.stroke(smile);
}
void draw_smile(Desk& desk) { draw_mouth(desk, -14, 4); }

TEST(Readings, AreOfferedAfterALineAndShownUnderThePen) {
  Desk desk("readings-shown");
  desk.begin();
  EXPECT_EQ(desk.interface->find("reading 1"), nullptr);
  draw_smile(desk);
  ASSERT_TRUE(offer_of(desk).open());
  ASSERT_NE(desk.interface->find("reading 1"), nullptr);
  const auto before = editing_of(desk).state();
  const Area button = *desk.interface->find("reading 1");
  EXPECT_GE(button.height(), desk.app->of<Canvas>().target_px() - 1) << "large enough for a pen";
  desk.app->of<Pointer>().moved(button.middle());
  desk.frames();
  EXPECT_NE(editing_of(desk).shown().pose(), desk.document().pose) << "the face shows it";
  desk.app->of<Pointer>().moved({button.middle().x, button.top - 200});
  desk.frames();
  EXPECT_EQ(editing_of(desk).shown().pose(), desk.document().pose);
  EXPECT_EQ(editing_of(desk).state(), before) << "nothing was done";
}

TEST(Readings, OneIsTakenAtAPressInOneStepAndCanBeTakenBack) {
  Desk desk("readings-take");
  desk.begin();
  draw_smile(desk);
  ASSERT_TRUE(offer_of(desk).open());
  const auto before = editing_of(desk).state();
  const rig::Pose first = desk.document().pose;
  const rig::Pose second = desk.document().moment->others[0].pose;
  const std::size_t steps = editing_of(desk).steps().list().size();
  desk.click("reading 1");
  EXPECT_EQ(desk.document().pose, second);
  EXPECT_EQ(editing_of(desk).shown().pose(), second) << "it is seen though the pen is still over the button";
  EXPECT_EQ(editing_of(desk).steps().list().size(), steps + 1);
  ASSERT_TRUE(offer_of(desk).open()) << "the first one stands there now";
  desk.click("reading 1");
  EXPECT_EQ(desk.document().pose, first);
  desk.press('z', true);
  EXPECT_EQ(desk.document().pose, second);
  desk.press('z', true);
  EXPECT_EQ(editing_of(desk).state(), before);
}

TEST(Readings, ASessionInWhichOneWasTakenReplaysToTheSameBits) {
  Desk desk("readings-replay");
  desk.begin();
  draw_smile(desk);
  desk.click("reading 1");
  desk.app->of<Actions>().run(Action::clear_curves);
  desk.app->of<Actions>().run(Action::reset_pose);
  desk.frames();
  draw_smile(desk);
  const auto played = replayed(desk.app->of<Recording>().path());
  ASSERT_TRUE(played && played->session) << played.error().line();
  EXPECT_FALSE(played->divergence);
  EXPECT_EQ(document::DocumentHasher()(played->session->editor().document()), editing_of(desk).state());
}

TEST(Readings, WithXMirrorBothSidesAreExchanged) {
  Desk desk("readings-mirror");
  desk.begin();
  desk.press('m');
  const auto mouth = desk.named_curve("lip_upper_inner");
  auto smirk = mouth;
  const double middle = 0.5 * (mouth.front().x + mouth.back().x);
  for (PxPoint& p : smirk) p.y -= 0.4 * std::max(0.0, p.x - middle);
  desk.stroke(mouth);
  desk.stroke(smirk);
  ASSERT_TRUE(offer_of(desk).open());
  desk.press('y');
  const auto parameters = desk.document().model->rig->parameters();
  const auto& pairs = editing_of(desk).two_sided_pairs();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (pairs[i] == k_no_pair) continue;
    EXPECT_NEAR(desk.document().pose[i], desk.document().pose[pairs[i]], 1e-9) << parameters[i].name;
  }
}

TEST(Readings, KeysTakeTheSecondAndTheThird) {
  Desk desk("readings-keys");
  desk.begin();
  desk.press('y');
  EXPECT_EQ(editing_of(desk).steps().list().size(), 0U) << "there is nothing to take";
  draw_mouth(desk, -10, 0);
  ASSERT_GE(offer_of(desk).readings().size(), 2U);
  const auto others = desk.document().moment->others;
  desk.press('y', false, true);
  EXPECT_EQ(desk.document().pose, others[1].pose);
  desk.press('z', true);
  EXPECT_FALSE(offer_of(desk).open()) << "what is undone asks no question";
}

TEST(Readings, AreGoneWithTheNextStepAndWhileThePenDraws) {
  Desk desk("readings-gone");
  desk.begin();
  draw_smile(desk);
  ASSERT_TRUE(offer_of(desk).open());
  const auto brow = desk.named_curve("brow_L");
  desk.stroke(brow, false);
  EXPECT_FALSE(offer_of(desk).open()) << "the pen draws";
  desk.app->of<Pointer>().button(MouseButton::left, false, brow.back());
  desk.frames();
  EXPECT_FALSE(offer_of(desk).open()) << "a line is there that asks for nothing yet";
}

TEST(Readings, ALineWhereItsCurveIsAsksForNothing) {
  Desk desk("readings-there");
  desk.begin();
  desk.stroke(desk.named_curve("lip_upper_inner"));
  desk.stroke(desk.named_curve("lip_upper_inner"));
  EXPECT_FALSE(offer_of(desk).open());
}

TEST(Readings, ArePicturesWithFewWordsOfEqualSize) {
  Desk desk("readings-pictures");
  desk.begin();
  draw_mouth(desk, -10, 0);
  ASSERT_GE(offer_of(desk).readings().size(), 2U);
  const Area* first = desk.interface->find("reading 1");
  const Area* second = desk.interface->find("reading 2");
  ASSERT_TRUE(first != nullptr && second != nullptr);
  EXPECT_GT(first->height(), first->width()) << "a square picture and a line of words below it";
  EXPECT_EQ(first->width(), second->width());
  EXPECT_LT(first->right, second->left);
}

TEST(Readings, TheWordsBelowAPictureSayWhatItMovesMostWithoutNumbers) {
  const auto brief = [](const std::string& words) {
    return OfferedReading{words, {}, {}, document::NameFaceLine{}}.brief();
  };
  EXPECT_EQ(brief("lips pucker +0.30; jaw opens -0.10 and 2 more"), "lips pucker");
  EXPECT_EQ(brief("smile -0.05"), "smile");
  EXPECT_EQ(brief("without jaw opens"), "without jaw opens");
  EXPECT_EQ(brief("without jaw opens; smile and 1 more"), "without jaw opens");
  EXPECT_EQ(brief("mouth corner down, left +1.00"), "mouth corner down, left");
  EXPECT_EQ(brief("inner lower lip"), "inner lower lip");
}

}  // namespace
}  // namespace penpose::app
