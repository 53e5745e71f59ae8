#include "core/io/project/internal/sketch_json.h"

#include <gtest/gtest.h>

#include "tests/support/models/articulation_models.h"

namespace penpose::io {
namespace {

TEST(SketchJson, ADeformersOwnViewportCountsBeforeThatOfTheFile) {
  const articulation::Sketch sketch = tests::make_trunk().curl();
  articulation::Sketch back;
  ASSERT_FALSE(read_sketch(to_json(sketch, Viewports::each), "", geometry::Viewport{1, 1}, back));
  EXPECT_EQ(back, sketch);
  articulation::Sketch other;
  ASSERT_FALSE(read_sketch(to_json(sketch, Viewports::shared), "", geometry::Viewport{7, 8}, other));
  EXPECT_EQ(other.viewport, (geometry::Viewport{7, 8}));
  const auto problem = read_sketch(to_json(sketch, Viewports::shared), "/x", std::nullopt, other);
  ASSERT_TRUE(problem.has_value());
  EXPECT_EQ(problem->place, "/x");
}

TEST(SketchJson, LeavesOutWhatIsAsUsual) {
  articulation::Sketch sketch = tests::make_trunk().curl();
  sketch.reference.clear();
  const json::Json json = to_json(sketch, Viewports::shared);
  for (const char* key : {"viewport", "reference", "reference_camera", "target_camera", "surface", "range"}) {
    EXPECT_FALSE(json.contains(key)) << key;
  }
}

}  // namespace
}  // namespace penpose::io
