#include "core/portrait/sketch/hatching.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "core/curve/polyline.h"
#include "core/portrait/sketch/face_layout.h"
#include "core/portrait/sketch/measures.h"
#include "core/portrait/sketch/pen_strokes.h"
#include "tests/core/portrait/drawn_face.h"

namespace penpose::portrait {
namespace {

using geometry::PxPoint;
using Line = std::vector<PxPoint>;

/// Strokes across a line, `apart` px from each other.
std::vector<Line> hatched(PxPoint from, PxPoint to, std::size_t count, double length) {
  std::vector<Line> strokes;
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    const PxPoint at = from + (to - from) * share;
    strokes.push_back({at + PxPoint{-0.2, 0.5} * length, at + PxPoint{0.2, -0.5} * length});
  }
  return strokes;
}

TEST(Hatching, ARowOfStrokesIsOneLineThroughTheirMiddles) {
  std::vector<Line> lines = hatched({100, 100}, {160, 80}, 10, 9);
  lines.push_back({{0, 0}, {400, 0}, {400, 400}});
  const JoinedLines joined = join_hatching(lines);
  ASSERT_EQ(joined.lines.size(), 2u);
  ASSERT_EQ(joined.joined_in.size(), lines.size());
  for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(joined.joined_in[i], 0u);
  EXPECT_EQ(joined.joined_in[10], 1u);
  const double reach = geometry::distance(joined.lines[0].front(), joined.lines[0].back());
  EXPECT_NEAR(reach, geometry::distance(PxPoint{100, 100}, PxPoint{160, 80}), 1e-9);
}

TEST(Hatching, FewStrokesAndStrokesOverEachOtherStayLines) {
  std::vector<Line> lines = hatched({100, 100}, {120, 100}, 3, 9);
  for (int i = 0; i < 5; ++i) lines.push_back({{200, 200 + 0.3 * i}, {210, 200 + 0.3 * i}});
  lines.push_back({{0, 0}, {400, 0}, {400, 400}});
  EXPECT_EQ(join_hatching(lines).lines.size(), lines.size());
}

TEST(Hatching, ABrowOfHairsTiltsAsItsRow) {
  DrawnFace drawn;
  auto lines = drawn.lines();
  const auto plain = find_face(lines);
  ASSERT_TRUE(plain);
  // The brows are drawn again as hairs that rise to the outer end.
  std::vector<Line> others;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (plain->marks[plain->mark_of_line[i]].part != FacePart::brow) others.push_back(lines[i]);
  }
  for (const Line& hair : hatched({125, 140}, {175, 160}, 12, 8)) others.push_back(hair);
  for (const Line& hair : hatched({225, 160}, {275, 140}, 12, 8)) others.push_back(hair);
  const auto face = find_face(others);
  ASSERT_TRUE(face);
  const FaceMeasures measures = measure(*face);
  for (std::size_t side = 0; side < 2; ++side) {
    ASSERT_TRUE(measures.brows[side]);
    EXPECT_NEAR(measures.brows[side]->tilt, 0.4, 0.03);
  }
}

TEST(PenStrokes, TheOutlineOfAThinArcIsTheArc) {
  Line outline;
  for (int i = 0; i <= 40; ++i) outline.push_back({5.0 * i, 40 - 0.004 * (5.0 * i - 100) * (5.0 * i - 100)});
  for (int i = 40; i >= 0; --i) outline.push_back({5.0 * i, 44 - 0.004 * (5.0 * i - 100) * (5.0 * i - 100)});
  outline.push_back(outline.front());
  const Line middle = middle_of_stroke(outline);
  EXPECT_NE(middle.size(), outline.size());
  EXPECT_GT(geometry::distance(middle.front(), middle.back()), 190);
  for (const PxPoint& p : middle) EXPECT_NEAR(p.y, 42 - 0.004 * (p.x - 100) * (p.x - 100), 2.5);
}

TEST(PenStrokes, AnEyeAndAnOpenLineStayAsTheyAre) {
  Line eye;
  for (int i = 0; i <= 24; ++i) {
    const double t = 2 * 3.14159265 * i / 24;
    eye.push_back({30 * std::cos(t), 14 * std::sin(t)});
  }
  EXPECT_EQ(middle_of_stroke(eye).size(), eye.size());
  const Line open{{0, 0}, {50, 3}, {100, 0}};
  EXPECT_EQ(middle_of_stroke(open).size(), open.size());
}

}  // namespace
}  // namespace penpose::portrait
