#include <gtest/gtest.h>

#include "tests/support/document_hand.h"

namespace penpose::document {
namespace {

using tests::DocumentHand;

TEST(ApplyParameters, SetsThoseThatAreNamed) {
  DocumentHand hand;
  hand.does(SetParameters{{{"lift", 0.25}, {"lean", -1}}});
  EXPECT_EQ(hand.value("lift"), 0.25);
  EXPECT_EQ(hand.value("lean"), -1);
  EXPECT_EQ(hand.value("base.rx"), 0);
}

TEST(ApplyParameters, RefusesUnknownNamesAndValuesOutOfRange) {
  DocumentHand hand;
  hand.does(SetParameters{{{"lift", 0.25}}});
  const auto unknown = hand.refuses(SetParameters{{{"lift", 0.5}, {"nose", 0.5}}});
  EXPECT_NE(unknown.what.find("\"nose\""), std::string::npos);
  EXPECT_EQ(unknown.place, "values");
  const auto range = hand.refuses(SetParameters{{{"lift", 1.5}}});
  EXPECT_NE(range.remedy.find("0 to 1"), std::string::npos) << range.line();
  hand.refuses(SetParameters{{{"lift", std::numeric_limits<double>::quiet_NaN()}}});
  EXPECT_EQ(hand.value("lift"), 0.25);
}

TEST(ApplyParameters, ResetsOneOrAll) {
  DocumentHand hand;
  hand.does(SetParameters{{{"lift", 0.25}, {"lean", 0.5}}});
  hand.does(ResetParameters{{"lift"}});
  EXPECT_EQ(hand.value("lift"), 0);
  EXPECT_EQ(hand.value("lean"), 0.5);
  hand.does(ResetParameters{});
  EXPECT_EQ(hand.value("lean"), 0);
  EXPECT_EQ(hand.refuses(ResetParameters{{"lift", "nose"}}).place, "names");
}

TEST(ApplyParameters, LocksAreKeptOnceAndInOrder) {
  DocumentHand hand;
  hand.does(LockParameters{{"lift", "lean", "lift"}, true});
  EXPECT_EQ(hand.document().locked, (std::vector<std::string>{"lean", "lift"}));
  hand.does(LockParameters{{"lean", "base.rx"}, false});
  EXPECT_EQ(hand.document().locked, std::vector<std::string>{"lift"});
  EXPECT_EQ(hand.refuses(LockParameters{{"lean", "nose"}, true}).place, "names");
}

TEST(ApplyParameters, ALockStopsTheSolverAndNoSlider) {
  DocumentHand hand;
  hand.does(LockParameters{{"lift"}, true});
  hand.does(SetParameters{{{"lift", 0.5}}});
  EXPECT_EQ(hand.value("lift"), 0.5);
  hand.does(ResetParameters{});
  EXPECT_EQ(hand.value("lift"), 0);
}

}  // namespace
}  // namespace penpose::document
