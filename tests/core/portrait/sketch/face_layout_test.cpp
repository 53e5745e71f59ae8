#include "core/portrait/sketch/face_layout.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "tests/core/portrait/drawn_face.h"

namespace penpose::portrait {
namespace {

using Line = DrawnFace::Line;

std::size_t count_of(const FaceLayout& layout, FacePart part) {
  return static_cast<std::size_t>(
      std::count_if(layout.marks.begin(), layout.marks.end(), [&](const FaceMark& mark) { return mark.part == part; }));
}

TEST(FaceLayout, EachLineIsThePartThatItIs) {
  const auto face = find_face(DrawnFace{}.lines());
  ASSERT_TRUE(face);
  EXPECT_EQ(count_of(*face, FacePart::eye), 2u);
  EXPECT_EQ(count_of(*face, FacePart::pupil), 2u);
  EXPECT_EQ(count_of(*face, FacePart::brow), 2u);
  EXPECT_EQ(count_of(*face, FacePart::nose), 1u);
  EXPECT_EQ(count_of(*face, FacePart::mouth), 1u);
  EXPECT_EQ(count_of(*face, FacePart::outline), 1u);
  EXPECT_NEAR(face->middle.x, 200, 1);
  EXPECT_NEAR(face->middle.y, 200, 1);
  EXPECT_NEAR(face->along.x, 100, 1);
}

TEST(FaceLayout, AHeadThatIsTiltedIsTheSameFace) {
  DrawnFace drawn;
  drawn.turn = 0.25;
  const auto face = find_face(drawn.lines());
  ASSERT_TRUE(face);
  EXPECT_NEAR(face->along.y / face->along.x, std::tan(0.25), 0.02);
  EXPECT_EQ(count_of(*face, FacePart::brow), 2u);
  EXPECT_EQ(count_of(*face, FacePart::mouth), 1u);
}

TEST(FaceLayout, LinesThatAreDrawnTwiceAreTheSameParts) {
  auto lines = DrawnFace{}.lines();
  const std::size_t once = lines.size();
  for (std::size_t i = 0; i < once; ++i) {
    lines.push_back(lines[i]);
    for (PxPoint& p : lines.back()) p = p + PxPoint{1.5, -1};
  }
  const auto face = find_face(lines);
  ASSERT_TRUE(face);
  for (std::size_t i = 0; i < once; ++i) EXPECT_EQ(face->marks[i].part, face->marks[once + i].part) << i;
}

TEST(FaceLayout, AHouseWithTwoWindowsAndADoorIsNone) {
  const auto box = [](double x, double y, double w, double h) {
    return Line{{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}, {x, y}};
  };
  EXPECT_FALSE(find_face(std::vector<Line>{box(100, 200, 200, 160),
                                           {{90, 200}, {200, 100}, {310, 200}},
                                           box(125, 230, 40, 40),
                                           box(235, 230, 40, 40),
                                           box(180, 290, 40, 70)}));
}

TEST(FaceLayout, OneLineOrNoneIsNone) {
  EXPECT_FALSE(find_face(std::vector<Line>{}));
  EXPECT_FALSE(find_face(std::vector<Line>{{{0, 0}, {10, 10}}}));
}

TEST(FaceLayout, SheetAndFrameAreInverse) {
  DrawnFace drawn;
  drawn.turn = -0.2;
  const auto face = find_face(drawn.lines());
  ASSERT_TRUE(face);
  const PxPoint back = face->on_sheet(face->in_frame({123, 77}));
  EXPECT_NEAR(back.x, 123, 1e-9);
  EXPECT_NEAR(back.y, 77, 1e-9);
}

}  // namespace
}  // namespace penpose::portrait
