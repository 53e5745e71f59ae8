#include <gtest/gtest.h>
#include <limits>

#include "tests/support/document_hand.h"

namespace penpose::document {
namespace {

using tests::DocumentHand;

std::vector<double> times(const Document& document) {
  std::vector<double> all;
  for (const PoseKey& key : document.timeline->keys) all.push_back(key.time_s);
  return all;
}

void key(DocumentHand& hand, double time_s, double lift) {
  hand.does(SetParameters{{{"lift", lift}}});
  hand.does(SetKey{time_s, ""});
}

TEST(ApplyTimeline, KeysStayInTheOrderOfTime) {
  DocumentHand hand;
  key(hand, 2, 0.2);
  key(hand, 0, 0.0);
  key(hand, 1, 0.1);
  EXPECT_EQ(times(hand.document()), (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(hand.document().timeline->keys[1].pose[0], 0.1);
  EXPECT_EQ(hand.document().time_s, 1);
}

TEST(ApplyTimeline, AKeyTakesThePlaceOfTheOneThatWasThere) {
  DocumentHand hand;
  key(hand, 1, 0.1);
  hand.does(SetParameters{{{"lift", 0.7}}});
  hand.does(SetKey{1, "smile"});
  ASSERT_EQ(hand.document().timeline->keys.size(), 1U);
  EXPECT_EQ(hand.document().timeline->keys[0].pose[0], 0.7);
  EXPECT_EQ(hand.document().timeline->keys[0].name, "smile");
}

TEST(ApplyTimeline, GoingToAMomentTakesItsPose) {
  DocumentHand hand;
  key(hand, 1, 0.2);
  key(hand, 2, 0.6);
  hand.does(SetKeyKind{{{1}, {}}, KeyKind::linear});
  hand.does(GoToTime{1.5});
  EXPECT_NEAR(hand.value("lift"), 0.4, 1e-12);
  EXPECT_EQ(hand.document().time_s, 1.5);
  hand.does(GoToTime{0});
  EXPECT_EQ(hand.value("lift"), 0.2) << "held before the first key";
  hand.does(GoToTime{36000});
  EXPECT_EQ(hand.value("lift"), 0.6);
}

TEST(ApplyTimeline, WhatIsPerformedIsKeyedOverWhatIsThere) {
  DocumentHand hand;
  hand.does(SetParameters{{{"lean", 0.25}}});
  key(hand, 0, 0.2);
  key(hand, 1.5, 0.6);
  hand.does(SetParameters{{{"lean", 0.75}}});
  key(hand, 4, 0.8);
  const auto lift = [&](double time_s) { return hand.does(GoToTime{time_s}), hand.value("lift"); };
  const auto lean = [&](double time_s) { return hand.does(GoToTime{time_s}), hand.value("lean"); };
  const double lean_was = lean(2);
  hand.does(KeyPoses{{"lift"}, {1, 2}, {0.1, 0.3}});
  EXPECT_EQ(times(hand.document()), (std::vector<double>{0, 1, 1.5, 2, 4}));
  EXPECT_EQ(lift(0), 0.2);
  EXPECT_EQ(lift(1), 0.1);
  EXPECT_GT(lift(1.5), 0.1);
  EXPECT_LT(lift(1.5), 0.3) << "what was keyed within the take is gone";
  EXPECT_EQ(lift(2), 0.3);
  EXPECT_EQ(lift(4), 0.8);
  EXPECT_EQ(lean(1), 0.25);
  EXPECT_EQ(lean(2), lean_was) << "what was not performed is as it was";
}

TEST(ApplyTimeline, WithoutKeysWhatIsPerformedIsKeyedOverThePose) {
  DocumentHand hand;
  hand.does(SetParameters{{{"lean", 0.25}}});
  hand.does(KeyPoses{{"lift"}, {0.5}, {0.4}});
  hand.does(GoToTime{0.5});
  EXPECT_EQ(hand.value("lift"), 0.4);
  EXPECT_EQ(hand.value("lean"), 0.25);
  EXPECT_EQ(hand.document().timeline->keys.size(), 1U);
  hand.does(SetParameters{{{"lean", 0.5}}});
  hand.does(GoToTime{0.5});
  EXPECT_EQ(hand.value("lean"), 0.5) << "a control without a key stays where it was put";
}

TEST(ApplyTimeline, WhatCannotHaveBeenPerformedIsRefused) {
  DocumentHand hand;
  EXPECT_EQ(hand.refuses(KeyPoses{{}, {0}, {}}).place, "names");
  EXPECT_EQ(hand.refuses(KeyPoses{{"lift"}, {}, {}}).place, "names");
  EXPECT_EQ(hand.refuses(KeyPoses{{"no such"}, {0}, {1}}).place, "names");
  EXPECT_EQ(hand.refuses(KeyPoses{{"lift", "lift"}, {0}, {1, 1}}).place, "names");
  EXPECT_EQ(hand.refuses(KeyPoses{{"lift"}, {0, 1}, {1}}).place, "values");
  EXPECT_EQ(hand.refuses(KeyPoses{{"lift"}, {1, 1}, {0.5, 0.5}}).place, "times_s");
  EXPECT_EQ(hand.refuses(KeyPoses{{"lift"}, {-1}, {0.5}}).place, "times_s");
  EXPECT_EQ(hand.refuses(KeyPoses{{"lift"}, {0}, {99}}).place, "values");
}

TEST(ApplyTimeline, WithoutKeysAMomentIsOnlyAMoment) {
  DocumentHand hand;
  hand.does(SetParameters{{{"lift", 0.5}}});
  hand.does(GoToTime{3});
  EXPECT_EQ(hand.value("lift"), 0.5);
  EXPECT_EQ(hand.document().time_s, 3);
}

/// One pair a key.
OfKeys lift_at(std::vector<double> times_s) {
  OfKeys keys{std::move(times_s), {}};
  keys.names.assign(keys.times_s.size(), "lift");
  return keys;
}

TEST(ApplyTimeline, KeysCanBeMovedAndDeleted) {
  DocumentHand hand;
  key(hand, 0, 0.1);
  key(hand, 1, 0.2);
  key(hand, 2, 0.3);
  EXPECT_EQ(hand.refuses(MoveKeys{{{0.5}, {}}, 3}).place, "times_s");
  EXPECT_EQ(hand.refuses(DeleteKeys{{{0.5}, {}}}).place, "times_s");
  EXPECT_EQ(hand.refuses(DeleteKeys{{{}, {}}}).place, "times_s");
  EXPECT_EQ(hand.refuses(DeleteKeys{{{1}, {"no such"}}}).place, "names");
  EXPECT_EQ(hand.refuses(DeleteKeys{{{1, 2}, {"lift"}}}).place, "names");
  hand.does(MoveKeys{{{0}, {}}, 1.5});
  EXPECT_EQ(times(hand.document()), (std::vector<double>{1, 1.5, 2}));
  EXPECT_EQ(hand.document().timeline->keys[1].pose[0], 0.1);
  hand.does(DeleteKeys{{{1.5}, {}}});
  EXPECT_EQ(times(hand.document()), (std::vector<double>{1, 2}));
}

TEST(ApplyTimeline, AKeyOfOneControlIsMovedByItself) {
  DocumentHand hand;
  hand.does(SetParameters{{{"lean", 0.25}}});
  key(hand, 0, 0.1);
  key(hand, 1, 0.2);
  key(hand, 2, 0.3);
  hand.does(MoveKeys{lift_at({1}), 0.5});
  EXPECT_EQ(times(hand.document()), (std::vector<double>{0, 1, 1.5, 2}));
  hand.does(GoToTime{1.5});
  EXPECT_EQ(hand.value("lift"), 0.2);
  EXPECT_EQ(hand.refuses(DeleteKeys{lift_at({1})}).place, "times_s") << "it went";
  // Onto another key of the control, which it replaces; the others stay.
  hand.does(MoveKeys{lift_at({1.5}), 0.5});
  EXPECT_EQ(times(hand.document()), (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(hand.document().timeline->keys[2].pose[0], 0.2);
  EXPECT_EQ(hand.document().timeline->keys[2].pose[1], 0.25);
}

TEST(ApplyTimeline, KeysAreScaledInTimeOntoFrames) {
  DocumentHand hand;
  for (const double time_s : {0.5, 1.0, 1.5}) key(hand, time_s, 0.4 * time_s);
  MoveKeys half{{{0.5, 1, 1.5}, {}}};
  half.about_s = 0.5;
  half.scale = 0.51;
  half.rate = 24;
  hand.does(half);
  EXPECT_EQ(times(hand.document()), (std::vector<double>{0.5, 18.0 / 24, 1}));
  hand.does(MoveKeys{{{0.5, 1}, {}}, 1, 0, 1, true});
  EXPECT_EQ(times(hand.document()), (std::vector<double>{0.5, 0.75, 1, 1.5, 2}));
  EXPECT_EQ(hand.document().timeline->keys[4].pose[0], 0.4 * 1.5);
  EXPECT_EQ(hand.refuses(MoveKeys{{{0.5}, {}}, -1}).place, "by_s");
  EXPECT_EQ(hand.refuses(MoveKeys{{{0.5}, {}}, 0, 0, 0}).place, "scale");
}

TEST(ApplyTimeline, ANamedMomentKeepsItsNameWhereAllOfItMoves) {
  DocumentHand hand;
  hand.does(SetKey{1, "smile"});
  hand.does(MoveKeys{lift_at({1}), 1});
  EXPECT_EQ(hand.document().timeline->keys[0].name, "smile");
  EXPECT_EQ(hand.document().timeline->keys[1].name, "");
  hand.does(MoveKeys{{{1}, {}}, 2});
  EXPECT_EQ(hand.document().timeline->keys.back().name, "smile");
}

TEST(ApplyTimeline, OneControlCanBeKeyedAlone) {
  DocumentHand hand;
  hand.does(SetParameters{{{"lift", 0.4}, {"lean", 0.25}}});
  hand.does(SetKey{1, "", {"lift"}});
  hand.does(SetParameters{{{"lift", 0.6}, {"lean", 0.75}}});
  hand.does(GoToTime{1});
  EXPECT_EQ(hand.value("lift"), 0.4);
  EXPECT_EQ(hand.value("lean"), 0.75);
  EXPECT_EQ(hand.refuses(SetKey{1, "", {"no such"}}).place, "names");
}

TEST(ApplyTimeline, AKeyThatBecomesFreeKeepsItsCurve) {
  DocumentHand hand;
  for (const double time_s : {0.0, 1.0, 2.0, 3.0}) key(hand, time_s, 0.1 * time_s * time_s);
  const auto lift = [&](double time_s) { return hand.does(GoToTime{time_s}), hand.value("lift"); };
  const double was = lift(1.4);
  hand.does(SetKeyKind{lift_at({0, 1, 2, 3}), KeyKind::free});
  EXPECT_NEAR(lift(1.4), was, 1e-12);
  hand.does(SetKeySlopes{1, "lift", 0, 0});
  EXPECT_LT(lift(1.4), was);
  EXPECT_EQ(hand.refuses(SetKeySlopes{1, "lift", 1e300, 0}).place, "in");
  EXPECT_EQ(hand.refuses(SetKeyKind{lift_at({1}), KeyKind::none}).place, "kind");
  hand.does(SetKeyValues{lift_at({1, 2}), {0.3, 0.2}});
  EXPECT_EQ(lift(1), 0.3);
  EXPECT_EQ(lift(2), 0.2);
  EXPECT_EQ(hand.refuses(SetKeyValues{lift_at({1}), {99}}).place, "values");
  EXPECT_EQ(hand.refuses(SetKeyValues{lift_at({1}), {}}).place, "values");
}

TEST(ApplyTimeline, OnlyAKeyThatIsAskedToOvershootLeavesTheRange) {
  DocumentHand hand;
  for (const double time_s : {0.0, 1.0, 2.0}) key(hand, time_s, 0.9);
  const auto lift = [&](double time_s) { return hand.does(GoToTime{time_s}), hand.value("lift"); };
  hand.does(SetKeySlopes{1, "lift", 2, 2});
  EXPECT_LE(lift(1.3), 1) << "a free one stays in it";
  hand.does(SetKeyKind{lift_at({1}), KeyKind::overshoot});
  hand.does(SetKeySlopes{1, "lift", 2, 2});
  EXPECT_NEAR(lift(1.3), 0.9 + 2 * 0.3 * 0.7 * 0.7, 1e-12);
  EXPECT_NEAR(lift(0.7), 0.9 - 2 * 0.3 * 0.7 * 0.7, 1e-12) << "on both sides";
  EXPECT_EQ(hand.refuses(SetKeyValues{lift_at({1}), {1.01}}).place, "values") << "keys stay in it";
  lift(1.3);
  hand.does(SetKey{1.3, "", {}});
  EXPECT_EQ(lift(1.3), 1) << "and a new key is set at its end";
  hand.does(SetKeyKind{lift_at({1}), KeyKind::free});
  EXPECT_LE(lift(1.1), 1);
}

TEST(ApplyTimeline, ALineBelongsToTheMomentAtWhichItWasDrawn) {
  DocumentHand hand;
  key(hand, 0, 0.1);
  key(hand, 2, 0.6);
  hand.does(GoToTime{1});
  hand.does(DrawReference{hand.view, hand.line(-0.5, 0.5, 0.5, 0.5)});
  const auto time = [&] { return hand.document().curves.front()->time_s; };
  EXPECT_EQ(time(), 1);
  hand.does(SetKey{1.5, "", {}});
  EXPECT_EQ(time(), 1.5) << "it goes along with its pose";
  hand.does(AddClip{"other"});
  hand.does(ShowClip{0});
  EXPECT_EQ(time(), 1.5);
  hand.does(GoToTime{0.25});
  EXPECT_EQ(time(), 1.5);
  hand.does(DrawTarget{hand.document().curves.front()->id, hand.view, hand.line(-0.5, 0.6, 0.5, 0.6), {}});
  EXPECT_EQ(time(), 0.25);
}

TEST(ApplyTimeline, ABreakdownStandsBetweenItsNeighbours) {
  DocumentHand hand;
  key(hand, 1, 0.2);
  key(hand, 2, 0.6);
  hand.does(Tween{1.5, 0.25, {}});
  EXPECT_NEAR(hand.value("lift"), 0.3, 1e-12);
  EXPECT_EQ(times(hand.document()), (std::vector<double>{1, 1.5, 2}));
  hand.does(Tween{1.5, 1.5, {"lift"}});
  EXPECT_NEAR(hand.value("lift"), 0.8, 1e-12) << "it overshoots";
  hand.does(Tween{1.5, 9, {}});
  EXPECT_EQ(hand.value("lift"), 1) << "within the range";
  EXPECT_EQ(hand.refuses(Tween{2.5, 0.5, {}}).place, "time_s");
  EXPECT_EQ(hand.refuses(Tween{1.5, std::numeric_limits<double>::infinity(), {}}).place, "share");
}

TEST(ApplyTimeline, RefusesMomentsThatAreNotOnTheTimeline) {
  DocumentHand hand;
  key(hand, 0, 0.1);
  for (const double moment : {-1e-9, 36000.5, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(hand.refuses(SetKey{moment, ""}).place, "time_s");
    EXPECT_EQ(hand.refuses(GoToTime{moment}).place, "time_s");
    EXPECT_EQ(hand.refuses(MoveKeys{{{0}, {}}, moment}).place, "by_s");
    hand.refuses(DeleteKeys{{{moment}, {}}});
  }
  EXPECT_EQ(hand.refuses(SetKey{1, "\xc3"}).place, "name");
}

TEST(ApplyTimeline, ViewsAreKeptByTheirNames) {
  DocumentHand hand;
  hand.does(SaveView{"front", hand.view});
  View side = hand.view;
  side.camera.eye = {6, 0, 0};
  hand.does(SaveView{"side", side});
  hand.does(SaveView{"front", side});
  ASSERT_EQ(hand.document().views.size(), 2U);
  EXPECT_EQ(hand.document().views[0]->name, "front");
  EXPECT_EQ(hand.document().views[0]->view, side);
  side.camera.vertical_fov_degrees = 0;
  EXPECT_EQ(hand.refuses(SaveView{"wide", side}).place, "view/vertical_fov_degrees");
  EXPECT_EQ(hand.refuses(SaveView{"", hand.view}).place, "name");
  hand.does(DeleteView{"front"});
  EXPECT_EQ(hand.document().views.size(), 1U);
  EXPECT_EQ(hand.refuses(DeleteView{"front"}).place, "name");
}

}  // namespace
}  // namespace penpose::document
