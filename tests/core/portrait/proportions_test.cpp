#include "core/portrait/proportions.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <utility>

namespace penpose::portrait {
namespace {

using geometry::PxPoint;
using Line = std::vector<PxPoint>;

/// Brows, eyes, a nose and a mouth about x = 0, y down.
const std::vector<Line> k_face = {{{-80, -40}, {-40, -40}}, {{40, -40}, {80, -40}}, {{-80, 0}, {-40, 0}},
                                  {{40, 0}, {80, 0}},       {{-10, 60}, {10, 60}},  {{-30, 100}, {30, 100}}};
const std::vector<Part> k_parts = {Part::brow, Part::brow, Part::eye, Part::eye, Part::nose, Part::mouth};

TEST(Proportions, EachMovesWhatItIsCalledAfterAndBothSidesAlike) {
  std::vector<std::vector<Line>> ways;
  for (const Proportion& one : proportions_of(k_face, k_parts)) ways.push_back(one.ways);
  ASSERT_EQ(ways.size(), 5u);
  // Eyes apart: brows go along, the mouth stays.
  EXPECT_EQ(ways[0][2][0], (PxPoint{-60, 0}));
  EXPECT_EQ(ways[0][3][0], (PxPoint{60, 0}));
  EXPECT_EQ(ways[0][1][0], (PxPoint{60, 0}));
  EXPECT_EQ(ways[0][5][0], (PxPoint{0, 0}));
  // A wide mouth, high brows, a long nose, a long face.
  EXPECT_EQ(ways[1][5][1], (PxPoint{30, 0}));
  EXPECT_EQ(ways[2][0][0], (PxPoint{0, -40}));
  EXPECT_EQ(ways[3][4][0], (PxPoint{0, 60}));
  EXPECT_EQ(ways[3][5][0], (PxPoint{0, 30}));
  EXPECT_EQ(ways[4][5][0], (PxPoint{0, 100}));
  EXPECT_EQ(ways[4][2][0], (PxPoint{0, 0}));
}

TEST(Proportions, WithoutEyesTheBrowsTellThemAndWithoutBothThereAreNone) {
  const std::vector<Line> brows(k_face.begin(), k_face.begin() + 2);
  EXPECT_EQ(proportions_of(brows, std::vector<Part>{Part::brow, Part::brow}).size(), 1u);
  EXPECT_TRUE(proportions_of(std::vector<Line>{k_face[5]}, std::vector<Part>{Part::mouth}).empty());
}

TEST(Proportions, PartsAreToldByTheNamesOfCurves) {
  const std::pair<const char*, Part> known[] = {
      {"brow_L", Part::brow},    {"Eyelid_Upper_R", Part::eye}, {"lip_lower_inner", Part::mouth},
      {"nose_base", Part::nose}, {"chin", Part::jaw},           {"horn", Part::other}};
  for (const auto& [name, part] : known) EXPECT_EQ(part_named(name), part) << name;
}

}  // namespace
}  // namespace penpose::portrait
