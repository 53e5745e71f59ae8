#include "ui/demo/run_demo.h"

#include <gtest/gtest.h>
#include <set>

#include "core/model_io/read_model.h"
#include "core/model_io/write_model.h"

namespace penpose::demo {
namespace {

TEST(RunDemo, PosesSixExpressionsOrMore) {
  const auto made = run_demo();
  ASSERT_TRUE(made.ok()) << made.error().line();
  EXPECT_GE(made->expressions.size(), 6U);
  std::set<std::vector<double>> poses;
  for (const PosedExpression& one : made->expressions) {
    EXPECT_GE(one.curves, 2U) << one.name;
    EXPECT_LT(one.solution.energy, 0.35 * one.solution.energy_start) << one.name;
    poses.insert(one.solution.pose);
  }
  EXPECT_EQ(poses.size(), made->expressions.size());
}

TEST(RunDemo, TheFileReadsBackEqual) {
  const auto made = run_demo();
  ASSERT_TRUE(made.ok());
  const auto bytes = model_io::write_glb(made->model);
  ASSERT_TRUE(bytes.ok()) << bytes.error().line();
  const auto read = model_io::read_model(*bytes, "demo.glb");
  ASSERT_TRUE(read.ok()) << read.error().line();
  EXPECT_EQ(document::state_hash(*read), document::state_hash(made->model));
  ASSERT_EQ(read->animations.size(), 1U);
  EXPECT_EQ(read->animations[0].channels[0].times_s.size(), 1 + 3 * made->expressions.size());
}

TEST(RunDemo, GivesTheSameBitsAgain) {
  const auto first = run_demo();
  const auto second = run_demo();
  ASSERT_TRUE(first.ok() && second.ok());
  EXPECT_EQ(document::state_hash(first->model), document::state_hash(second->model));
  for (std::size_t i = 0; i < first->expressions.size(); ++i) {
    EXPECT_EQ(first->expressions[i].solution.pose, second->expressions[i].solution.pose);
  }
}

}  // namespace
}  // namespace penpose::demo
