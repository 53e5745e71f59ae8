#include "core/io/surface/normals.h"

#include <gtest/gtest.h>

#include "tests/support/models/model_samples.h"

namespace penpose::io {
namespace {

TEST(Normals, AreWeightedByArea) {
  // A large triangle in z = 0 and a small one in x = 0 share vertex 0.
  const std::vector<mesh::ModelPoint> positions = {{0, 0, 0}, {3, 0, 0}, {0, 1, 0}, {0, 1, 0}, {0, 0, 1}, {9, 9, 9}};
  const std::vector<mesh::Triangle> triangles = {{0, 1, 2}, {0, 3, 4}};
  const std::vector<std::uint32_t> groups = {0, 1, 2, 3, 4, 5};
  const auto normals = smooth_normals(positions, triangles, groups);
  EXPECT_NEAR(normals[0].z / normals[0].x, 3.0F, 1e-6F);
  EXPECT_EQ(normals[1], glm::vec3(0, 0, 1));
  EXPECT_EQ(normals[4], glm::vec3(1, 0, 0));
  EXPECT_EQ(normals[5], glm::vec3(0, 0, 1));  // without a triangle
  const std::vector<std::uint32_t> joined = {0, 1, 2, 2, 4, 5};
  EXPECT_EQ(smooth_normals(positions, triangles, joined)[2], smooth_normals(positions, triangles, joined)[3]);
}

TEST(Normals, MissingOnesAreFilledAndOthersGetLengthOne) {
  mesh::MeshSource source;
  tests::add_square(source, "a", 0);
  source.normals = {{0, 3, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  fill_missing_normals(source);
  EXPECT_EQ(source.normals[0], glm::vec3(0, 1, 0));
  EXPECT_EQ(source.normals[1], glm::vec3(0, 0, 1));
}

}  // namespace
}  // namespace penpose::io
