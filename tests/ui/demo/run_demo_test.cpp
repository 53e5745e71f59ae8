#include "ui/demo/run_demo.h"

#include <gtest/gtest.h>
#include <set>

#include "core/character/demo_head.h"
#include "core/document/document_hash.h"
#include "core/io/project/read_document.h"
#include "core/io/project/write_document.h"

namespace penpose::demo {
namespace {

TEST(RunDemo, ReplaysThePenToSixExpressionsOrMore) {
  const auto made = run_demo();
  ASSERT_TRUE(made.ok()) << made.error().line();
  EXPECT_GT(made->reports, 3000U);
  EXPECT_GT(made->states_checked, made->strokes) << "a state after every stroke and command";
  EXPECT_GE(made->poses.size(), 6U);
  std::set<std::vector<double>> poses;
  for (const NamedPose& one : made->poses) {
    EXPECT_GE(one.curves, 2U) << one.name;
    // Depth is left open, while targets stand as deep as their references: a jaw that turns goes back.
    EXPECT_LT(one.distance, 0.42 * one.distance_at_rest) << one.name;
    poses.insert(one.pose);
  }
  EXPECT_EQ(poses.size(), made->poses.size());
}

TEST(RunDemo, TheBuiltInControlsAreThoseThatItSketches) {
  const auto made = run_demo();
  ASSERT_TRUE(made.ok());
  document::Model sketched = *made->document.model;
  sketched.pose = rig::rest_pose(*sketched.rig);
  document::DocumentHasher hasher;
  EXPECT_EQ(hasher(document::make_document(character::make_demo_head().value())).whole,
            hasher(document::make_document(std::move(sketched))).whole);
}

TEST(RunDemo, TheProjectReadsBackEqual) {
  const auto made = run_demo();
  ASSERT_TRUE(made.ok());
  const auto bytes = io::write_project(made->document);
  ASSERT_TRUE(bytes.ok()) << bytes.error().line();
  const auto read = io::read_document(*bytes, "demo.glb");
  ASSERT_TRUE(read.ok()) << read.error().line();
  document::DocumentHasher hasher;
  EXPECT_EQ(differing_parts(hasher(*read), hasher(made->document)), (std::vector<std::string_view>{}));
  EXPECT_EQ(hasher(*read).whole, hasher(made->document).whole);
  EXPECT_EQ(read->timeline->keys.size(), 1 + 3 * made->poses.size());
}

TEST(RunDemo, ShowsOtherProgramsItsTimeline) {
  const auto made = run_demo();
  ASSERT_TRUE(made.ok());
  const auto model = io::read_model(io::write_project(made->document).value(), "demo.glb");
  ASSERT_TRUE(model.ok());
  ASSERT_EQ(model->animations.size(), 1U);
  EXPECT_EQ(model->animations[0].name, "timeline");
  EXPECT_EQ(model->animations[0].channels[0].times_s.size(), made->document.timeline->keys.size());
}

}  // namespace
}  // namespace penpose::demo
