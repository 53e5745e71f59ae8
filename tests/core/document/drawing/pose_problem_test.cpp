#include "core/document/drawing/pose_problem.h"

#include <gtest/gtest.h>

#include "tests/support/document_hand.h"

namespace penpose::document {
namespace {

using tests::DocumentHand;

TEST(IntentProblem, HoldsTheLatestTargetsAndWhatIsLocked) {
  DocumentHand hand;
  hand.does(LockParameters{{"base.rx", "base.ry", "base.rz", "lift", "lean"}, true});
  for (std::uint32_t i = 1; i <= k_most_meant + 3; ++i) {
    const double y = -0.8 + 0.07 * i;
    hand.does(DrawReference{hand.view, hand.line(-0.5, y, 0.5, y)});
    hand.does(DrawTarget{CurveId{i}, hand.view, hand.line(-0.5, y + 0.01 * i, 0.5, y + 0.01 * i), {}});
  }
  const auto problem = intent_problem(hand.document());
  ASSERT_EQ(problem.drawn.size(), k_most_meant);
  EXPECT_EQ(problem.drawn.back().target, hand.document().curves.back()->target->line);
  EXPECT_EQ(problem.locked.size(), 5U);
  EXPECT_EQ(problem.free.size() + problem.locked.size(), problem.start.size());
}

TEST(IntentProblem, TheHandCounts) {
  DocumentHand hand;
  const geometry::Viewport viewport = hand.view.viewport;
  const double usual = hand_px(hand.document(), viewport);
  hand.does(SetHand{2});
  EXPECT_DOUBLE_EQ(hand_px(hand.document(), viewport), 2 * usual);
}

}  // namespace
}  // namespace penpose::document
