#include "core/joints/run.h"

#include <gtest/gtest.h>

#include "tests/support/models/stick_figure.h"

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
  EXPECT_EQ(runs(tests::stick_man(), {1, 2, 3}), (std::vector<Joints>{{1, 2}, {2, 3}, {1, 2, 3}}));
}

TEST(Run, DoesNotGoThroughAHinge) { EXPECT_TRUE(runs(tests::stick_man(), {6, 7, 8}).empty()); }

TEST(Run, DoesNotBeginWhereOtherLimbsPart) {
  // The hips carry a leg, too: what they turn is more than the line of action.
  for (const Joints& run : runs(tests::stick_man(), {0, 1, 2, 3, 4, 5})) EXPECT_NE(run.front(), 0U);
  EXPECT_EQ(runs(tests::stick_man(), {0, 1, 2, 3, 4, 5}).size(), 10U);
}

TEST(Run, KeepsToOneLimb) {
  // Two straight feelers on a body, drawn from tip to tip.
  tests::StickFigure figure;
  figure.add(-1, {0, 0, 0}, {0, 0.2, 0});
  for (int k = 0; k < 2; ++k) figure.add(k, {0.2 + 0.3 * k, 0, 0}, {0.5 + 0.3 * k, 0, 0});
  figure.add(0, {-0.2, 0, 0}, {-0.5, 0, 0});
  figure.add(3, {-0.5, 0, 0}, {-0.8, 0, 0});
  EXPECT_EQ(runs(figure, {1, 2, 3, 4}), (std::vector<Joints>{{1, 2}, {3, 4}}));
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
