#include <gtest/gtest.h>

#include "core/document/document.h"
#include "tests/support/document_hand.h"

namespace penpose::document {
namespace {

using tests::DocumentHand;

double keyed(const Document& document, double time_s, const char* control) {
  return pose_at(document, time_s)[*rig::find_parameter(document.model->rig->parameters(), control)];
}

const base::Hash128 k_content{1, 2};

TEST(SoundCommands, ASoundIsLaidMovedAndTakenAway) {
  DocumentHand hand;
  EXPECT_TRUE(is_plain(hand.document()));
  hand.does(SetSound{"talk.wav", k_content, 0.5});
  EXPECT_FALSE(is_plain(hand.document())) << "saved as a project";
  hand.does(MoveSound{-1.25});
  ASSERT_NE(hand.document().sound, nullptr);
  EXPECT_EQ(*hand.document().sound, (SoundReference{"talk.wav", k_content, -1.25}));
  hand.does(RemoveSound{});
  EXPECT_EQ(hand.document().sound, nullptr);
  ASSERT_TRUE(hand.undo().ok());
  EXPECT_EQ(hand.document().sound->offset_s, -1.25);
}

TEST(SoundCommands, WhatIsNoSoundIsRefused) {
  DocumentHand hand;
  EXPECT_EQ(hand.refuses(RemoveSound{}).what, "there is no sound");
  EXPECT_EQ(hand.refuses(MoveSound{1}).what, "there is no sound");
  EXPECT_EQ(hand.refuses(SetSound{"", k_content, 0}).place, "file");
  EXPECT_EQ(hand.refuses(SetSound{std::string(5000, 'a'), k_content, 0}).place, "file");
  EXPECT_EQ(hand.refuses(SetSound{"a.wav", k_content, 36001}).place, "offset_s");
}

TEST(SoundCommands, MouthsAreKeyedWithTheControlsThatTheyMoveAndNoOthers) {
  DocumentHand hand;
  hand.does(SetParameters{{{"lean", 0.25}}});
  hand.does(SetMouth{"open", {{"lift", 0.75}}});
  hand.does(SetMouth{"rest", {}});
  hand.does(SetKey{0, ""});
  hand.does(SetParameters{{{"lean", 1}}});
  hand.does(SetKey{2, ""});
  hand.does(KeyMouths{{0.5, 1, 1.5}, {"rest", "open", "rest"}});
  EXPECT_EQ(keyed(hand.document(), 0.5, "lift"), 0);
  EXPECT_EQ(keyed(hand.document(), 1, "lift"), 0.75);
  EXPECT_EQ(keyed(hand.document(), 1.5, "lift"), 0);
  EXPECT_GT(keyed(hand.document(), 1, "lean"), 0.25) << "goes on as it did";
  EXPECT_LT(keyed(hand.document(), 1, "lean"), 1);
  ASSERT_TRUE(hand.undo().ok());
  EXPECT_EQ(hand.document().timeline->keys.size(), 2U) << "one step";
  EXPECT_EQ(hand.document().spoken, nullptr);
}

TEST(SoundCommands, KeysFollowAMouthThatIsDrawnAgain) {
  DocumentHand hand;
  hand.does(SetMouth{"open", {{"lift", 0.75}}});
  hand.does(SetMouth{"rest", {}});
  hand.does(KeyMouths{{0.5, 1, 1.5, 2}, {"open", "rest", "open", "open"}});
  hand.does(SetMouth{"open", {{"lift", 0.5}, {"lean", 0.25}}});
  for (const double time_s : {0.5, 1.5, 2.0}) {
    EXPECT_EQ(keyed(hand.document(), time_s, "lift"), 0.5) << time_s;
    EXPECT_EQ(keyed(hand.document(), time_s, "lean"), 0.25) << time_s;
  }
  EXPECT_EQ(keyed(hand.document(), 1, "lift"), 0);
  EXPECT_EQ(keyed(hand.document(), 1, "lean"), 0) << "a mouth that does not move a control has it at rest";
  ASSERT_TRUE(hand.undo().ok());
  EXPECT_EQ(keyed(hand.document(), 0.5, "lift"), 0.75);
}

MoveKeys moves(std::vector<double> times_s, double by_s) {
  MoveKeys move;
  move.times_s = std::move(times_s);
  move.by_s = by_s;
  return move;
}

TEST(SoundCommands, AKeyThatWasMovedStillFollowsItsMouth) {
  DocumentHand hand;
  hand.does(SetMouth{"open", {{"lift", 0.75}}});
  hand.does(SetMouth{"rest", {}});
  hand.does(KeyMouths{{0.5, 1, 1.5}, {"open", "rest", "open"}});
  hand.does(moves({0.5}, 0.25));
  MoveKeys scaled = moves({1.5}, 0);
  scaled.about_s = 1;
  scaled.scale = 3;
  hand.does(scaled);
  hand.does(SetMouth{"open", {{"lift", 0.5}}});
  EXPECT_EQ(keyed(hand.document(), 0.75, "lift"), 0.5);
  EXPECT_EQ(keyed(hand.document(), 2.5, "lift"), 0.5);
  EXPECT_EQ(keyed(hand.document(), 1, "lift"), 0);
  EXPECT_EQ(hand.document().timeline->keys.size(), 3U) << "none where it was before";
  ASSERT_TRUE(hand.undo().ok());
  ASSERT_TRUE(hand.undo().ok());
  ASSERT_TRUE(hand.undo().ok());
  hand.does(SetMouth{"open", {{"lift", 0.25}}});
  EXPECT_EQ(keyed(hand.document(), 0.5, "lift"), 0.25) << "back where they were, they follow there";
}

TEST(SoundCommands, ACopyFollowsItsMouthAndOneThatIsMovedOverAnotherTakesItsPlace) {
  DocumentHand hand;
  hand.does(SetMouth{"open", {{"lift", 0.75}}});
  hand.does(SetMouth{"rest", {}});
  hand.does(KeyMouths{{0.5, 1, 1.5}, {"open", "rest", "open"}});
  MoveKeys copied = moves({0.5}, 2);
  copied.copies = true;
  hand.does(copied);
  hand.does(moves({0.5}, 0.5));
  hand.does(SetMouth{"open", {{"lift", 0.5}}});
  EXPECT_EQ(keyed(hand.document(), 2.5, "lift"), 0.5);
  EXPECT_EQ(keyed(hand.document(), 1, "lift"), 0.5) << "in place of the rest";
  EXPECT_EQ(hand.document().spoken->size(), 3U);
  hand.does(SetMouth{"rest", {{"lift", 0.1}}});
  EXPECT_EQ(keyed(hand.document(), 1, "lift"), 0.5) << "no longer a rest";
}

TEST(SoundCommands, AMouthOfWhichOnlySomeControlsWereMovedStays) {
  DocumentHand hand;
  hand.does(SetMouth{"open", {{"lift", 0.75}, {"lean", 0.25}}});
  hand.does(KeyMouths{{0.5, 1.5}, {"open", "open"}});
  MoveKeys move = moves({0.5}, 0.25);
  move.names = {"lift"};
  hand.does(move);
  hand.does(SetMouth{"open", {{"lift", 0.5}}});
  EXPECT_EQ(keyed(hand.document(), 0.75, "lift"), 0.75) << "changed by hand";
  EXPECT_EQ(keyed(hand.document(), 0.5, "lean"), 0.25);
  EXPECT_EQ(keyed(hand.document(), 1.5, "lift"), 0.5);
}

TEST(SoundCommands, AKeyThatTheArtistChangedStaysAsItIs) {
  DocumentHand hand;
  hand.does(SetMouth{"open", {{"lift", 0.75}}});
  hand.does(SetMouth{"rest", {}});
  hand.does(KeyMouths{{0.5, 1, 1.5}, {"open", "rest", "open"}});
  hand.does(GoToTime{0.5});
  hand.does(SetParameters{{{"lift", 0.9}}});
  hand.does(SetKey{0.5, ""});
  hand.does(SetMouth{"open", {{"lift", 0.25}}});
  EXPECT_EQ(keyed(hand.document(), 0.5, "lift"), 0.9);
  EXPECT_EQ(keyed(hand.document(), 1.5, "lift"), 0.25);
}

TEST(SoundCommands, ThePoseInHandFollowsToo) {
  DocumentHand hand;
  hand.does(SetMouth{"open", {{"lift", 0.75}}});
  hand.does(KeyMouths{{0.5}, {"open"}});
  hand.does(GoToTime{0.5});
  hand.does(SetMouth{"open", {{"lift", 0.25}}});
  EXPECT_EQ(hand.value("lift"), 0.25);
}

TEST(SoundCommands, ADeletedMouthLeavesItsKeys) {
  DocumentHand hand;
  hand.does(SetMouth{"open", {{"lift", 0.75}}});
  hand.does(SetMouth{"rest", {}});
  hand.does(KeyMouths{{0.5, 1}, {"open", "rest"}});
  hand.does(DeleteMouth{"open"});
  EXPECT_EQ(hand.document().mouths.size(), 1U);
  EXPECT_EQ(hand.document().spoken->size(), 1U);
  EXPECT_EQ(keyed(hand.document(), 0.5, "lift"), 0.75);
  hand.does(DeleteMouth{"rest"});
  EXPECT_EQ(hand.document().spoken, nullptr);
}

TEST(SoundCommands, WhatIsNoMouthIsRefused) {
  DocumentHand hand;
  EXPECT_EQ(hand.refuses(SetMouth{"", {}}).place, "name");
  EXPECT_EQ(hand.refuses(SetMouth{"open", {{"nothing", 1}}}).what, "the model has no parameter \"nothing\"");
  EXPECT_EQ(hand.refuses(SetMouth{"open", {{"lift", 0.5}, {"lift", 0.5}}}).what, "\"lift\" is named twice");
  EXPECT_FALSE(hand.perform(SetMouth{"open", {{"lift", 1e6}}}).ok());
  EXPECT_EQ(hand.refuses(DeleteMouth{"open"}).place, "name");
  EXPECT_EQ(hand.refuses(KeyMouths{{0}, {"open"}}).what, "there is no mouth \"open\"");
  hand.does(SetMouth{"rest", {}});
  EXPECT_EQ(hand.refuses(KeyMouths{{0}, {"rest"}}).what, "these mouths move nothing");
  hand.does(SetMouth{"open", {{"lift", 0.5}}});
  EXPECT_EQ(hand.refuses(KeyMouths{{0, 1}, {"open"}}).place, "mouths");
  EXPECT_EQ(hand.refuses(KeyMouths{{1, 0}, {"open", "open"}}).place, "times_s");
  EXPECT_EQ(hand.refuses(KeyMouths{{-1}, {"open"}}).place, "times_s");
}

TEST(SoundCommands, MouthsFollowAControlThatIsRenamedAndLoseOneThatIsGone) {
  DocumentHand hand;
  hand.sketch("up");
  hand.does(SetMouth{"open", {{"up", 0.5}, {"lift", 0.25}}});
  hand.does(RenameDeformer{"up", "high"});
  const auto has = [&](const char* control) {
    const auto& values = hand.document().mouths.front()->values;
    return std::any_of(values.begin(), values.end(), [&](const NamedValue& one) { return one.name == control; });
  };
  EXPECT_TRUE(has("high"));
  hand.does(DeleteDeformer{"high"});
  EXPECT_FALSE(has("high"));
  EXPECT_TRUE(has("lift"));
}

TEST(SoundCommands, WordsStayWithTheirSoundAndGoWithIt) {
  DocumentHand hand;
  EXPECT_EQ(hand.refuses(SetWords{{0.5}, {"hello"}}).what, "there is no sound");
  hand.does(SetSound{"talk.wav", k_content, 0});
  hand.does(SetWords{{0.25, 0.5}, {"hello", "there"}});
  ASSERT_NE(hand.document().words, nullptr);
  EXPECT_EQ(*hand.document().words, (SpokenWords{{0.25, "hello"}, {0.5, "there"}}));
  hand.does(MoveSound{2});
  hand.does(SetSound{"moved/talk.wav", k_content, 2});
  EXPECT_NE(hand.document().words, nullptr) << "the same sound under another name";
  hand.does(SetSound{"other.wav", base::Hash128{3, 4}, 0});
  EXPECT_EQ(hand.document().words, nullptr);
  ASSERT_TRUE(hand.undo().ok());
  EXPECT_EQ(hand.document().words->size(), 2U);
  hand.does(RemoveSound{});
  EXPECT_EQ(hand.document().words, nullptr);
}

TEST(SoundCommands, WhatAreNoWordsIsRefused) {
  DocumentHand hand;
  hand.does(SetSound{"talk.wav", k_content, 0});
  EXPECT_EQ(hand.refuses(SetWords{{0.5, 1}, {"hello"}}).place, "words");
  EXPECT_EQ(hand.refuses(SetWords{{0.5, 0.25}, {"a", "b"}}).place, "times_s");
  EXPECT_EQ(hand.refuses(SetWords{{-1}, {"a"}}).place, "times_s");
  EXPECT_EQ(hand.refuses(SetWords{{0}, {""}}).place, "words");
  EXPECT_EQ(hand.refuses(SetWords{{0}, {std::string(201, 'a')}}).place, "words");
}

}  // namespace
}  // namespace penpose::document
