#include <gtest/gtest.h>

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
  hand.does(SetKeyInterpolation{KeyInterpolation::linear});
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
  hand.does(SetKeyInterpolation{KeyInterpolation::linear});
  hand.does(KeyPoses{{"lift"}, {1, 2}, {0.1, 0.3}});
  EXPECT_EQ(times(hand.document()), (std::vector<double>{0, 1, 1.5, 2, 4}));
  const auto lift = [&](double time_s) { return hand.does(GoToTime{time_s}), hand.value("lift"); };
  const auto lean = [&](double time_s) { return hand.does(GoToTime{time_s}), hand.value("lean"); };
  EXPECT_EQ(lift(0), 0.2);
  EXPECT_EQ(lift(1), 0.1);
  EXPECT_NEAR(lift(1.5), 0.2, 1e-12) << "a key within the take goes evenly from one moment of it to the next";
  EXPECT_EQ(lift(2), 0.3);
  EXPECT_EQ(lift(4), 0.8);
  EXPECT_EQ(lean(1), 0.25) << "what was not performed is as it was";
  EXPECT_NEAR(lean(2), 0.25 + 0.5 * (0.5 / 2.5), 1e-12);
}

TEST(ApplyTimeline, WithoutKeysWhatIsPerformedIsKeyedOverThePose) {
  DocumentHand hand;
  hand.does(SetParameters{{{"lean", 0.25}}});
  hand.does(KeyPoses{{"lift"}, {0.5}, {0.4}});
  hand.does(GoToTime{0.5});
  EXPECT_EQ(hand.value("lift"), 0.4);
  EXPECT_EQ(hand.value("lean"), 0.25);
  EXPECT_EQ(hand.document().timeline->keys.size(), 1U);
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

TEST(ApplyTimeline, KeysCanBeMovedAndDeleted) {
  DocumentHand hand;
  key(hand, 0, 0.1);
  key(hand, 1, 0.2);
  key(hand, 2, 0.3);
  EXPECT_EQ(hand.refuses(MoveKey{0, 2}).place, "to_s");
  EXPECT_EQ(hand.refuses(MoveKey{0.5, 3}).place, "from_s");
  EXPECT_EQ(hand.refuses(DeleteKey{0.5}).place, "time_s");
  hand.does(MoveKey{0, 1.5});
  EXPECT_EQ(times(hand.document()), (std::vector<double>{1, 1.5, 2}));
  EXPECT_EQ(hand.document().timeline->keys[1].pose[0], 0.1);
  hand.does(MoveKey{2, 2});
  hand.does(DeleteKey{1.5});
  EXPECT_EQ(times(hand.document()), (std::vector<double>{1, 2}));
}

TEST(ApplyTimeline, RefusesMomentsThatAreNotOnTheTimeline) {
  DocumentHand hand;
  key(hand, 0, 0.1);
  for (const double moment : {-1e-9, 36000.5, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(hand.refuses(SetKey{moment, ""}).place, "time_s");
    EXPECT_EQ(hand.refuses(GoToTime{moment}).place, "time_s");
    EXPECT_EQ(hand.refuses(MoveKey{0, moment}).place, "to_s");
    hand.refuses(DeleteKey{moment});
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
