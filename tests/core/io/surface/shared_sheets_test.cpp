#include <cmath>
#include <gtest/gtest.h>

#include "core/curve/sheet_line.h"
#include "core/io/model/read_model.h"
#include "tests/support/models/sheet_lines.h"
#include "tests/support/shared_data.h"

// Lines drawn by an unsteady hand over real models, lips, lids and rims among them: each stays on one sheet.

namespace penpose::io {
namespace {

class SharedSheets : public testing::TestWithParam<const char*> {};

TEST_P(SharedSheets, LinesNeverLeaveTheSheetThatTheyAreOn) {
  if (!tests::has_shared()) GTEST_SKIP();
  auto model = read_model(tests::read_file(tests::shared_dir() / "meshes" / GetParam()), GetParam());
  ASSERT_TRUE(model.ok());
  const mesh::TriangleMesh& mesh = *model->mesh;
  const std::vector<glm::vec3> positions(mesh.positions().begin(), mesh.positions().end());
  const geometry::TriangleBvh tree(positions, mesh.triangles());
  curve::Sheets sheets(mesh);
  std::vector<std::vector<std::uint32_t>> beside(mesh.vertex_count());
  for (const mesh::Triangle& t : mesh.triangles()) {
    for (std::size_t k = 0; k < 3; ++k) {
      beside[mesh.weld()[t[k]]].push_back(mesh.weld()[t[(k + 1) % 3]]);
      beside[mesh.weld()[t[(k + 1) % 3]]].push_back(mesh.weld()[t[k]]);
    }
  }
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
    const auto curve = curve::sheet_curve(line, 32, camera, {tree, positions, mesh.triangles(), sheets});
    if (!curve) continue;
    ++drawn;
    for (std::size_t k = 0; k + 1 < curve->points.size(); ++k) {
      const std::uint32_t one = curve->points[k].triangle, two = curve->points[k + 1].triangle;
      // A walk looks at least 2 px of a picture 1000 px high ahead.
      const double step = std::max(length / 31, 2.0) * camera.units_per_px(camera.depth(curve->positions[k]));
      if (sheets.component(one) != sheets.component(two)) {
        EXPECT_LT(geometry::distance(curve->positions[k], curve->positions[k + 1]), 8 * step + 1e-9)
            << "parts may be crossed where they touch; line " << i;
        continue;
      }
      double edge = 0;
      for (const std::uint32_t t : {one, two}) {
        const mesh::Triangle& c = mesh.triangles()[t];
        for (std::size_t e = 0; e < 3; ++e)
          edge = std::max(edge, geometry::distance(mesh.positions()[c[e]], mesh.positions()[c[(e + 1) % 3]]));
      }
      const double chord = geometry::distance(curve->positions[k], curve->positions[k + 1]);
      const double most = 2 * chord + 6 * step + 4 * edge;
      EXPECT_LE(tests::way_over_surface(mesh, beside, one, two, most), most) << "line " << i << " at point " << k;
    }
  }
  EXPECT_GT(drawn, 200);
}

INSTANTIATE_TEST_SUITE_P(Meshes, SharedSheets,
                         testing::Values("ict_face.glb", "ict_face_narrow.glb", "carry_head.glb", "elephant.glb",
                                         "cesium_man.glb"));

}  // namespace
}  // namespace penpose::io
