#include "core/document/features/known_heads.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/io/model/read_model.h"
#include "tests/support/models/rendered_track.h"
#include "tests/support/shared_data.h"

namespace penpose::document {
namespace {

document::Model face() {
  return io::read_model(tests::read_file(tests::shared_dir() / "meshes" / "ict_face.glb"), "ict_face.glb").value();
}

/// The same model with its vertices elsewhere and, where asked for, its controls renamed.
document::Model changed(const document::Model& from,
                        const std::function<geometry::ModelPoint(geometry::ModelPoint)>& move, bool rename) {
  mesh::MeshSource source;
  for (const auto& p : from.mesh->positions()) source.positions.push_back(move(p));
  source.triangles.assign(from.mesh->triangles().begin(), from.mesh->triangles().end());
  source.parts.assign(from.mesh->parts().begin(), from.mesh->parts().end());
  std::vector<rig::BlendShape> shapes(from.shapes->shapes().begin(), from.shapes->shapes().end());
  for (std::size_t i = 0; rename && i < shapes.size(); ++i) shapes[i].parameter.name = "control" + std::to_string(i);
  const auto mesh = mesh::TriangleMesh::build(std::move(source)).value();
  auto made = rig::BlendShapes::make(std::move(shapes), mesh->vertex_count()).value();
  return document::make_model(mesh, std::move(made), nullptr).value();
}

TEST(SharedKnownHeads, TwentyIdentitiesAreKnownWhateverTheirControlsAreCalled) {
  if (!tests::has_shared()) GTEST_SKIP();
  const auto model = face();
  ASSERT_EQ(known_head_curves(model).size(), 10U);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    // A smooth warp of three waves along each axis: up to 6 % of a head of 25 cm, of no symmetry, turned and scaled.
    tests::Shaker random(seed);
    std::array<double, 27> a{};
    for (double& one : a) one = random();
    const double turn = 3 * random();
    const double scale = std::exp(3 * random());
    const auto warp = [&](geometry::ModelPoint p) {
      geometry::ModelPoint q = p;
      for (std::size_t k = 0; k < 9; ++k) {
        q[static_cast<int>(k % 3)] +=
            0.5 * a[k] * std::sin(0.25 * (p[0] * a[9 + k] + p[1] * a[18 + k]) + 3 * a[(k + 5) % 27]);
      }
      return geometry::ModelPoint(std::cos(turn) * q.x - std::sin(turn) * q.y,
                                  std::sin(turn) * q.x + std::cos(turn) * q.y, q.z) *
             scale;
    };
    EXPECT_EQ(known_head_curves(changed(model, warp, seed % 2 == 0)).size(), 10U) << seed;
  }
}

TEST(SharedKnownHeads, VerticesInAnotherOrderAreNotTakenForIt) {
  if (!tests::has_shared()) GTEST_SKIP();
  const auto bytes = tests::read_file(tests::shared_dir() / "meshes" / "carry_head_answer.glb");
  EXPECT_TRUE(known_head_curves(io::read_model(bytes, "carry_head_answer.glb").value()).empty());
}

}  // namespace
}  // namespace penpose::document
