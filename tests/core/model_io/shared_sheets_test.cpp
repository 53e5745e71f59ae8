#include <gtest/gtest.h>

#include "core/model_io/read_model.h"
#include "tests/support/shared_data.h"
#include "tests/support/sheet_lines.h"

// Lines drawn by an unsteady hand over real models, lips, lids and rims among them: each stays on one sheet.

namespace penpose::model_io {
namespace {

class SharedSheets : public testing::TestWithParam<const char*> {};

TEST_P(SharedSheets, LinesNeverLeaveTheSheetThatTheyAreOn) {
  if (!tests::has_shared()) GTEST_SKIP();
  auto model = read_model(tests::read_file(tests::shared_dir() / "meshes" / GetParam()), GetParam());
  ASSERT_TRUE(model.ok());
  // As lines of older rules stick to it.
  EXPECT_GT(tests::SheetLines(*model->mesh, curve::Holding::loose).draw(400, 11, false), 200);
}

INSTANTIATE_TEST_SUITE_P(Meshes, SharedSheets,
                         testing::Values("ict_face.glb", "ict_face_narrow.glb", "carry_head.glb", "elephant.glb",
                                         "cesium_man.glb"));

}  // namespace
}  // namespace penpose::model_io
