#include "core/model_io/case_file.h"

#include <gtest/gtest.h>

#include "core/model_io/read_model.h"
#include "tests/support/shared_data.h"

namespace penpose::model_io {
namespace {

TEST(SharedMeshes, PoseCasesFitTheFace) {
  if (!tests::has_shared()) GTEST_SKIP();
  const auto meshes = tests::shared_dir() / "meshes";
  const auto model = read_model(tests::read_file(meshes / "ict_face.glb"), "ict_face.glb");
  ASSERT_TRUE(model.ok()) << model.error().line();
  const auto cases = read_cases(tests::read_file(meshes / "ict_face_pose_cases.json"));
  ASSERT_TRUE(cases.ok()) << cases.error().line();
  EXPECT_EQ(cases->cases.size(), 12U);
  EXPECT_TRUE(check_cases(*cases, *model).ok());
}

}  // namespace
}  // namespace penpose::model_io
