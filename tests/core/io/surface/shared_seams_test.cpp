#include <gtest/gtest.h>

#include "core/io/model/read_model.h"
#include "tests/support/models/sheet_lines.h"
#include "tests/support/shared_data.h"

namespace penpose::io {
namespace {

class SharedSeams : public testing::TestWithParam<const char*> {};

TEST_P(SharedSeams, LinesNeverLeaveTheSheetThatTheyAreOn) {
  if (!tests::has_shared()) GTEST_SKIP();
  auto model = read_model(tests::read_file(tests::shared_dir() / "meshes" / GetParam()), GetParam());
  ASSERT_TRUE(model.ok());
  tests::SheetLines lines(*model->mesh);
  EXPECT_GT(lines.draw(400, 11, false), 200);
  if (lines.seam_count() > 50) {
    EXPECT_GT(lines.draw(400, 12, true), 100) << "along seams";
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, SharedSeams,
                         testing::Values("ict_face.glb", "ict_face_narrow.glb", "carry_head.glb", "elephant.glb",
                                         "cesium_man.glb"));

}  // namespace
}  // namespace penpose::io
