#include <gtest/gtest.h>

#include "core/document/expressions.h"
#include "tests/support/models/square_with_shapes.h"

namespace penpose::document {
namespace {

using enum ExpressionOverride;

/// Expressions that each move a shape of their own.
Model face() {
  Model model = tests::square_with_shapes({"s0", "s1", "s2"});
  model.expressions = {{"aa", {{0, 1}}}, {"Blink_L", {{1, 1}}}, {"happy", {{2, 1}}}};
  return model;
}
using Weights = std::vector<double>;

TEST(ShownWeights, ABinaryExpressionIsShownWhollyOrNotAtAll) {
  Model model = face();
  model.expressions[1].is_binary = true;
  EXPECT_EQ(shown_weights(model, Weights{0.4, 0.5, 0.3}), (Weights{0.4, 0, 0.3}));
  EXPECT_EQ(shown_weights(model, Weights{0.4, 0.51, 0.3}), (Weights{0.4, 1, 0.3}));
}

TEST(ShownWeights, WhatIsOverriddenGivesWay) {
  Model model = face();
  model.expressions[2].mouth = block;
  model.expressions[2].blink = blend;
  EXPECT_EQ(shown_weights(model, Weights{0.8, 1, 0}), (Weights{0.8, 1, 0}));
  EXPECT_EQ(shown_weights(model, Weights{0.8, 1, 0.25}), (Weights{0, 0.75, 0.25}));
  // A binary one that is not shown overrides nothing.
  model.expressions[2].is_binary = true;
  EXPECT_EQ(shown_weights(model, Weights{0.8, 1, 0.25}), (Weights{0.8, 1, 0}));
}

TEST(ShownWeights, ApplyingAnExpressionBringsWhatItOverridesToRest) {
  Model model = face();
  model.expressions[2].mouth = block;
  model.expressions[2].blink = blend;
  rig::Pose pose{0.6, 0.8, 0};
  set_expression(model, model.expressions[2], 0.5, pose);
  EXPECT_EQ(pose, (rig::Pose{0, 0.4, 0.5}));
  model.expressions[2].is_binary = true;
  pose = {0.6, 0.8, 0.3};
  set_expression(model, model.expressions[2], 0.5, pose);
  EXPECT_EQ(pose, (rig::Pose{0.6, 0.8, 0})) << "half of a binary one is none of it";
}

}  // namespace
}  // namespace penpose::document
