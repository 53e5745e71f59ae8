#include <cmath>
#include <gtest/gtest.h>

#include "core/io/model/read_model.h"
#include "tests/support/models/sheet_lines.h"
#include "tests/support/shared_data.h"

// Lines drawn by an unsteady hand over real models, lips, lids and rims among them: each stays on one sheet.

namespace penpose::io {
namespace {

class SharedSheets : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!tests::has_shared()) GTEST_SKIP();
    auto model = read_model(tests::read_file(tests::shared_dir() / "meshes" / GetParam()), GetParam());
    ASSERT_TRUE(model.ok());
    mesh_ = model->mesh;
  }
  std::shared_ptr<const mesh::TriangleMesh> mesh_;
};

TEST_P(SharedSheets, LinesNeverLeaveTheSheetThatTheyAreOn) {
  const mesh::TriangleMesh& mesh = *mesh_;
  tests::SheetLines sheet_lines(mesh);
  tests::Random random(11);
  int drawn = 0;
  for (int i = 0; i < 400; ++i) {
    const auto camera = geometry::frame_box(mesh.rest_box(), {1280, 960}, random(-50, 50), random(-15, 15));
    // From one place in the picture of a vertex to another, so that seams of the model are among them.
    const auto a = camera.project(mesh.positions()[random.index(mesh.vertex_count())]);
    const geometry::PxPoint start = a.value_or(geometry::PxPoint{640, 480});
    const double length = random(30, 300), bend = random(-0.01, 0.01);
    double across = random(-1, 1), along = random(-1, 1);
    const double norm = std::hypot(across, along);
    std::vector<geometry::PxPoint> line;
    for (double s = 0; s < length; s += 3) {
      const double way = bend * s * s;
      line.push_back({start.x + (along * s - across * way) / norm + random(-2, 2),
                      start.y + (across * s + along * way) / norm + random(-2, 2)});
    }
    drawn += sheet_lines.check(line, camera, length, i) ? 1 : 0;
  }
  EXPECT_GT(drawn, 200);
}

TEST_P(SharedSheets, LinesOverSeamsNeverLeaveTheSheetThatTheyAreOn) {
  tests::SheetLines lines(*mesh_);
  EXPECT_GT(lines.draw(400, 11, false), 200);
  if (lines.seam_count() > 50) {
    EXPECT_GT(lines.draw(400, 12, true), 100) << "along seams";
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, SharedSheets,
                         testing::Values("ict_face.glb", "ict_face_narrow.glb", "carry_head.glb", "elephant.glb",
                                         "cesium_man.glb"));

}  // namespace
}  // namespace penpose::io
