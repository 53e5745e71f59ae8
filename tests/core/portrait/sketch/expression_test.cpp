#include "core/portrait/sketch/expression.h"

#include <gtest/gtest.h>

#include "tests/core/portrait/drawn_face.h"

namespace penpose::portrait {
namespace {

Expression shown_by(const DrawnFace& drawn, const std::optional<RestingFace>& rest = {}) {
  const auto face = find_face(drawn.lines());
  EXPECT_TRUE(face);
  return face ? expression_of(measure(*face), rest) : Expression{};
}

TEST(Expression, AFaceAtRestShowsNothing) { EXPECT_TRUE(shown_by({}).rests()); }

TEST(Expression, ProportionsAreNoExpression) {
  DrawnFace wide;
  wide.half_width = 55;
  EXPECT_TRUE(shown_by(wide).rests());
  DrawnFace low;
  low.brow_inner = low.brow_outer = {-6, -6};
  EXPECT_TRUE(shown_by(low).rests());
}

TEST(Expression, CornersOfTheMouth) {
  DrawnFace smile;
  smile.smile = 16;
  const auto up = shown_by(smile);
  ASSERT_TRUE(up.mouth);
  EXPECT_GT(up.mouth->corners[0], 0.1);
  EXPECT_NEAR(up.mouth->corners[0], up.mouth->corners[1], 0.02);
  DrawnFace frown;
  frown.smile = -16;
  EXPECT_LT(shown_by(frown).mouth->corners[1], -0.1);
}

TEST(Expression, InnerEndsOfBrowsUpAreSadAndDownAreAngry) {
  DrawnFace sad;
  sad.brow_inner = {20, 20};
  EXPECT_LT(shown_by(sad).brows[0]->tilted, -0.2);
  DrawnFace angry;
  angry.brow_outer = {20, 20};
  EXPECT_GT(shown_by(angry).brows[1]->tilted, 0.2);
}

TEST(Expression, OneBrowUp) {
  DrawnFace one;
  one.brow_inner[1] = one.brow_outer[1] = 25;
  const auto shown = shown_by(one);
  EXPECT_EQ(shown.brows[0]->raised, 0);
  EXPECT_GT(shown.brows[1]->raised, 0.1);
}

TEST(Expression, AnEyeThatIsALineBesideAnOpenOneIsShut) {
  DrawnFace wink;
  wink.shut[1] = true;
  const auto shown = shown_by(wink);
  EXPECT_EQ(*shown.closed[1], 1);
  EXPECT_LE(*shown.closed[0], 0);
}

TEST(Expression, LidsThatComeDownLowerNoBrow) {
  DrawnFace sleepy;
  sleepy.lowered = 0.5;
  const auto shown = shown_by(sleepy);
  for (const std::size_t side : {0U, 1U}) {
    EXPECT_GT(*shown.closed[side], 0.35);
    EXPECT_LT(*shown.closed[side], 0.7);
    EXPECT_EQ(shown.brows[side]->raised, 0) << "the gap below it is the lid's";
  }
}

TEST(Expression, OneCornerIsRaisedAlone) {
  DrawnFace rest;
  const auto face = find_face(rest.lines());
  ASSERT_TRUE(face);
  FaceMeasures measures = measure(*face);
  measures.mouth->corners = {0.16, -0.1};
  const auto shown = expression_of(measures, {});
  EXPECT_GT(shown.mouth->corners[0], 0.08);
  EXPECT_EQ(shown.mouth->corners[1], 0);
}

TEST(Expression, AnOpenMouth) {
  DrawnFace open;
  open.gap = 40;
  EXPECT_GT(shown_by(open).mouth->opened, 0.2);
}

TEST(Expression, BesideTheSameHandsFaceAtRestLessIsAnExpression) {
  DrawnFace rest;
  rest.brow_inner = rest.brow_outer = {15, 15};
  DrawnFace little = rest;
  little.smile = 5;
  const auto face = find_face(rest.lines());
  ASSERT_TRUE(face);
  const RestingFace known{measure(*face), 0.6};
  EXPECT_TRUE(shown_by(rest, known).rests());
  EXPECT_GT(shown_by(little, known).mouth->corners[0], 0);
  EXPECT_EQ(shown_by(little, known).brows[0]->raised, 0);
}

}  // namespace
}  // namespace penpose::portrait
