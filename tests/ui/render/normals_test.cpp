#include "ui/render/normals.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/support/render_shapes.h"

namespace penpose::render {
namespace {

TEST(Normals, OfASpherePointOutwardAtAnySize) {
  for (const double radius : {1e-12, 1.0, 1e12}) {
    const auto model = sphere_model(radius);
    const auto positions = to_float(model.mesh->positions());
    const auto normals = smooth_normals(*model.mesh, positions);
    for (std::size_t v = 0; v < normals.size(); ++v) {
      const glm::dvec3 outward = glm::normalize(glm::dvec3(positions[v]));
      EXPECT_GT(glm::dot(outward, glm::dvec3(normals[v])), 0.999) << radius;
    }
  }
}

TEST(Normals, FollowThePosedPositions) {
  mesh::MeshSource source;
  source.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  source.triangles = {{0, 1, 2}};
  const auto mesh = mesh::TriangleMesh::build(source).value();
  const std::vector<glm::vec3> turned{{0, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_EQ(smooth_normals(*mesh, turned)[0], glm::vec3(1, 0, 0));
}

TEST(Normals, EdgesThatTheFileKeepsHardStayHard) {
  // Two squares at a right angle; their shared edge is split in the file by its normals.
  mesh::MeshSource source;
  source.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}, {0, 1, 0}, {0, 1, -1}, {0, 0, -1}};
  source.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {-1, 0, 0}, {-1, 0, 0}, {-1, 0, 0}, {-1, 0, 0}};
  source.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  const auto mesh = mesh::TriangleMesh::build(source).value();
  const auto normals = smooth_normals(*mesh, to_float(mesh->positions()));
  EXPECT_EQ(normals[0], glm::vec3(0, 0, 1));
  EXPECT_EQ(normals[4], glm::vec3(-1, 0, 0));
}

}  // namespace
}  // namespace penpose::render
