#include "core/portrait/sketch/measures.h"

#include <gtest/gtest.h>

#include "tests/core/portrait/drawn_face.h"

namespace penpose::portrait {
namespace {

FaceMeasures measured(const DrawnFace& drawn) { return measure(find_face(drawn.lines()).value()); }

TEST(Measures, BrowsAreMeasuredUpAndFromTheirInnerEnd) {
  DrawnFace drawn;
  drawn.brow_outer = {10, 10};
  const auto face = measured(drawn);
  for (const auto& brow : face.brows) {
    ASSERT_TRUE(brow);
    // The eyes are 100 px apart; the brow is 46 px wide and rises by 10.
    EXPECT_NEAR(brow->height, 0.45, 0.01);
    EXPECT_NEAR(brow->tilt, 10.0 / 46, 0.01);
    EXPECT_NEAR(brow->bend, 0, 0.01);
  }
}

TEST(Measures, AnEyeIsOpenAndALineIsALine) {
  DrawnFace drawn;
  drawn.shut[0] = true;
  const auto face = measured(drawn);
  ASSERT_TRUE(face.eyes[0] && face.eyes[1]);
  EXPECT_EQ(face.eyes[0]->kind, EyeKind::line);
  EXPECT_EQ(face.eyes[1]->kind, EyeKind::open);
  EXPECT_NEAR(face.eyes[1]->opening, 28.0 / 40, 0.03);
  EXPECT_NEAR(face.eyes[1]->arched, 0.5, 0.05);
  DrawnFace sleepy;
  sleepy.lowered = 0.5;
  EXPECT_NEAR(measured(sleepy).eyes[1]->arched, 0, 0.1) << "nothing lies above the corners";
}

TEST(Measures, CornersAreOverTheMiddleOfTheMouth) {
  DrawnFace drawn;
  drawn.smile = 16;
  const auto face = measured(drawn);
  ASSERT_TRUE(face.mouth);
  EXPECT_TRUE(face.mouth->shut);
  EXPECT_NEAR(face.mouth->width, 0.8, 0.02);
  EXPECT_NEAR(face.mouth->corners[0], 0.2, 0.03);
  EXPECT_NEAR(face.mouth->corners[1], 0.2, 0.03);
}

TEST(Measures, AnOpenMouthHasAGap) {
  DrawnFace drawn;
  drawn.gap = 40;
  const auto face = measured(drawn);
  ASSERT_TRUE(face.mouth);
  EXPECT_FALSE(face.mouth->shut);
  EXPECT_NEAR(face.mouth->gap, 0.5, 0.05);
}

TEST(Measures, LipsThatPartContradictALineAndBrowsThatTiltTheOtherWayABrow) {
  const auto rest = measured({});
  DrawnFace open;
  open.gap = 40;
  EXPECT_TRUE(contradicts(rest, measured(open), rest));
  EXPECT_FALSE(contradicts(measured(open), measured(open), rest));
  DrawnFace angry;
  angry.brow_outer = {20, 20};
  DrawnFace sad;
  sad.brow_inner = {20, 20};
  EXPECT_TRUE(contradicts(measured(angry), measured(sad), rest));
  EXPECT_FALSE(contradicts(measured(angry), measured(angry), rest));
}

}  // namespace
}  // namespace penpose::portrait
