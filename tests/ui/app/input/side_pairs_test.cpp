#include "ui/app/input/side_pairs.h"

#include <gtest/gtest.h>

namespace penpose::app {
namespace {

const std::vector<rig::Parameter> k_face{{"browDown_L"}, {"browDown_R"},         {"jawOpen"}, {"jawLeft"},
                                         {"jawRight"},   {"smile_L", 0, 0, 0.5}, {"smile_R"}};

TEST(SidePairs, SidesAreFoundByTheirNames) {
  const auto pairs = side_pairs(k_face);
  EXPECT_EQ(pairs, (std::vector<std::size_t>{1, 0, k_no_pair, 4, 3, 6, 5}));
  EXPECT_EQ(common_name("browDown_L", "browDown_R"), "browDown");
  EXPECT_EQ(common_name("jawLeft", "jawRight"), "jaw");
  EXPECT_EQ(common_name("left brow", "right brow"), "brow");
  EXPECT_EQ(common_name("L", "R"), "L") << "nothing is in common";
  EXPECT_TRUE(is_left("jawLeft", "jawRight"));
  EXPECT_FALSE(is_left("jawRight", "jawLeft"));
}

TEST(SidePairs, APoseIsFlippedAsFarAsTheOtherSideCan) {
  const rig::Pose pose{0.2, 0.0, 0.7, 0.3, 0.0, 0.1, 0.9};
  const auto out = flipped(k_face, side_pairs(k_face), pose, pose.size());
  EXPECT_EQ(out, (rig::Pose{0.0, 0.2, 0.7, 0.0, 0.3, 0.5, 0.1}));
}

TEST(SidePairs, OneSideIsCopiedOverTheOther) {
  const rig::Pose pose{0.2, 0.4, 0.7, 0.3, 0.0, 0.1, 0.9};
  // What jawLeft does is not done on two sides.
  const auto pairs =
      two_sided(side_pairs(k_face), std::vector<std::size_t>{1, 0, k_no_pair, k_no_pair, k_no_pair, 6, 5});
  EXPECT_EQ(copied_over(k_face, pairs, pose, pose.size(), true), (rig::Pose{0.2, 0.2, 0.7, 0.3, 0.0, 0.1, 0.1}));
  EXPECT_EQ(copied_over(k_face, pairs, pose, pose.size(), false), (rig::Pose{0.4, 0.4, 0.7, 0.3, 0.0, 0.5, 0.9}));
  EXPECT_EQ(copied_over(k_face, pairs, pose, 0, true), pose) << "joints stay";
}

TEST(SidePairs, WhatIsDoneOnOneSideIsDoneOnBoth) {
  const auto pairs = side_pairs(k_face);
  const rig::Pose rest(k_face.size(), 0.0);
  const auto brow = on_both_sides(k_face, pairs, rest, {0.6, 0, 0.1, 0, 0, 0, 0}, rest.size());
  ASSERT_TRUE(brow);
  EXPECT_EQ(*brow, (rig::Pose{0.6, 0.6, 0.1, 0, 0, 0, 0}));
  EXPECT_FALSE(on_both_sides(k_face, pairs, rest, {0.6, 0.5, 0, 0, 0, 0, 0}, rest.size())) << "both were drawn";
  EXPECT_FALSE(on_both_sides(k_face, pairs, rest, {0, 0, 0.6, 0, 0, 0, 0}, rest.size())) << "none was";
  // A wink that is there already is not made a blink by a brow.
  const rig::Pose winks{0, 0, 0, 0, 0, 0.4, 0};
  const auto after = on_both_sides(k_face, pairs, winks, {0.6, 0, 0, 0, 0, 0.4, 0}, rest.size());
  ASSERT_TRUE(after);
  EXPECT_EQ((*after)[6], 0);
}

}  // namespace
}  // namespace penpose::app
