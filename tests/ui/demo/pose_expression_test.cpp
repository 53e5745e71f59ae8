#include "ui/demo/pose_expression.h"

#include <gtest/gtest.h>

#include "ui/demo/demo_head.h"

namespace penpose::demo {
namespace {

TEST(PoseExpression, AnEmptySpaceBesideTheHeadIsNoReference) {
  const auto model = make_demo_head();
  const auto file = demo_expressions();
  ASSERT_TRUE(model.ok() && file.ok());
  const auto surface = rest_surface(*model);
  Expression expression = file->expressions.front();
  const auto problem = problem_of_expression(*model, surface, expression, file->viewport);
  ASSERT_TRUE(problem.ok()) << problem.error().line();
  EXPECT_EQ(problem->pairs.size(), expression.curves.size());
  EXPECT_EQ(problem->free.size(), model->rig->parameters().size());

  expression.curves[1].reference = {{1, 1}, {9, 1}};
  const auto beside = problem_of_expression(*model, surface, expression, file->viewport);
  ASSERT_FALSE(beside.ok());
  EXPECT_EQ(beside.error().place, expression.name + ", curve 1");
  expression.camera.look_at = expression.camera.eye;
  EXPECT_FALSE(problem_of_expression(*model, surface, expression, file->viewport).ok());
}

TEST(PoseExpression, TargetsOnTheReferenceLeaveTheFaceAtRest) {
  const auto model = make_demo_head();
  auto file = demo_expressions();
  ASSERT_TRUE(model.ok() && file.ok());
  Expression expression = file->expressions.front();
  for (DrawnPair& pair : expression.curves) pair.target = pair.reference;
  posing::SolveWorkspace work;
  const auto posed = pose_expression(*model, rest_surface(*model), expression, file->viewport, work);
  ASSERT_TRUE(posed.ok()) << posed.error().line();
  for (const double value : posed->solution.pose) EXPECT_NEAR(value, 0, 0.05);
}

}  // namespace
}  // namespace penpose::demo
