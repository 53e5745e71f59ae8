#include "core/mesh/triangle_mesh.h"

#include <gtest/gtest.h>

namespace penpose::mesh {
namespace {

TEST(TriangleMesh, PositionsAreFloats) {
  MeshSource source;
  source.positions = {{0.1, 0.2, 0.3}, {1.1, 0.2, 0.3}, {0.1, 1.2, 0.7}};
  source.triangles = {{0, 1, 2}};
  const auto mesh = TriangleMesh::build(source);
  ASSERT_TRUE(mesh);
  for (std::size_t v = 0; v < 3; ++v) {
    for (int k = 0; k < 3; ++k) {
      const volatile float rounded = static_cast<float>(source.positions[v][k]);
      EXPECT_EQ((*mesh)->positions()[v][k], static_cast<double>(rounded));
    }
  }
}

}  // namespace
}  // namespace penpose::mesh
