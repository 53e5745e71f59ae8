#include "core/joints/run.h"

#include <gtest/gtest.h>

#include "tests/support/stick_figure.h"

namespace penpose::joints {
namespace {

using Joints = std::vector<std::size_t>;

std::vector<Joints> runs(const tests::StickFigure& figure, const Joints& chain) {
  const auto skeleton = figure.skeleton();
  const Body body(*skeleton);
  std::vector<Joints> out;
  for (const joints::Run& run : runs_of(body, body.rest(), chain, std::nullopt)) out.push_back(run.joints);
  return out;
}

TEST(Run, IsEveryStretchOfAChain) {
  EXPECT_EQ(runs(tests::stick_man(), {6, 7, 8}), (std::vector<Joints>{{6, 7}, {7, 8}, {6, 7, 8}}));
}

TEST(Run, DoesNotBeginWhereOtherLimbsPart) {
  // The hips carry a leg, too: what they turn is more than the line of action.
  for (const Joints& run : runs(tests::stick_man(), {0, 1, 2, 3, 4, 5})) EXPECT_NE(run.front(), 0U);
  EXPECT_EQ(runs(tests::stick_man(), {0, 1, 2, 3, 4, 5}).size(), 10U);
}

TEST(Run, KeepsToOneLimb) {
  for (const Joints& run : runs(tests::stick_man(), {6, 7, 12, 13})) EXPECT_EQ(run.size(), 2U);
}

TEST(Run, OfALongChainAreCoarser) {
  tests::StickFigure rope;
  for (int k = 0; k < 60; ++k) rope.add(k - 1, {0, k, 0}, {0, k + 1, 0}, 0.2);
  Joints chain(60);
  for (std::size_t k = 0; k < 60; ++k) chain[k] = k;
  const auto all = runs(rope, chain);
  EXPECT_LE(all.size(), 12U * 13U / 2U);
  EXPECT_EQ(all.back(), chain);
}

TEST(Run, BendsInThePictureWhereItLiesAcrossTheView) {
  const auto skeleton = tests::stick_man().skeleton();
  const Body body(*skeleton);
  const Joints chain{1, 2, 3};
  for (const joints::Run& run : runs_of(body, body.rest(), chain, ModelVector{0, 0, -1})) {
    EXPECT_TRUE(run.planar);
    EXPECT_EQ(run.axes[0], (ModelVector{0, 0, -1}));
  }
  for (const joints::Run& run : runs_of(body, body.rest(), chain, ModelVector{0, -1, 0})) EXPECT_FALSE(run.planar);
}

}  // namespace
}  // namespace penpose::joints
