#include "core/mesh/triangle_mesh.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/mesh/topology.h"

namespace penpose::mesh {
namespace {

/// Two triangles that form a square.
MeshSource square() {
  MeshSource source;
  source.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  source.triangles = {{0, 1, 2}, {0, 2, 3}};
  return source;
}

base::Error error_of(MeshSource source) {
  const auto mesh = TriangleMesh::build(std::move(source));
  return mesh ? base::Error{"built", "", ""} : mesh.error();
}

TEST(TriangleMesh, KeepsWhatItWasBuiltFrom) {
  const auto mesh = TriangleMesh::build(square()).value();
  EXPECT_EQ(mesh->vertex_count(), 4U);
  EXPECT_EQ(mesh->triangle_count(), 2U);
  EXPECT_EQ(mesh->positions()[2], (ModelPoint{1, 1, 0}));
  EXPECT_EQ(mesh->triangles()[1], (Triangle{0, 2, 3}));
  EXPECT_EQ(mesh->rest_box().minimum, (ModelPoint{0, 0, 0}));
  EXPECT_EQ(mesh->rest_box().maximum, (ModelPoint{1, 1, 0}));
  EXPECT_EQ(mesh->component_count(), 1U);
  EXPECT_EQ(mesh->dropped_triangles(), 0U);
  ASSERT_EQ(mesh->parts().size(), 1U);
  EXPECT_EQ(mesh->parts()[0].vertex_count, 4U);
  EXPECT_EQ(mesh->parts()[0].triangle_count, 2U);
  EXPECT_TRUE(mesh->file_normals().empty());
}

TEST(TriangleMesh, RoundsPositionsToFloat) {
  MeshSource source = square();
  source.positions[1].x = 0.1;
  const auto mesh = TriangleMesh::build(source).value();
  EXPECT_EQ(mesh->positions()[1].x, static_cast<double>(0.1F));
}

TEST(TriangleMesh, NamesWhatIsWrong) {
  EXPECT_EQ(error_of({}).what, "the mesh has no vertices");

  MeshSource source = square();
  source.positions[3].y = std::nan("");
  EXPECT_EQ(error_of(source).place, "vertex 3");
  source.positions[3].y = 1e39;  // no float
  EXPECT_EQ(error_of(source).place, "vertex 3");

  source = square();
  source.triangles[1][2] = 4;
  EXPECT_EQ(error_of(source).place, "triangle 1");
  EXPECT_FALSE(error_of(source).remedy.empty());

  source = square();
  source.normals.assign(3, {0, 0, 1});
  EXPECT_NE(error_of(source).what, "built");

  source = square();
  source.positions.emplace_back(0, 0, 1);
  source.triangles.push_back({2, 0, 4});
  EXPECT_EQ(error_of(source).what, "built") << "the third triangle at the edge 0-2 is a sheet of its own";
}

TEST(TriangleMesh, RefusesPartsThatDoNotCoverIt) {
  const auto with_parts = [](std::vector<Part> parts) {
    MeshSource source = square();
    source.parts = std::move(parts);
    return error_of(std::move(source)).what != "built";
  };
  EXPECT_FALSE(with_parts({{"a", 0, 4, 0, 2}}));
  EXPECT_FALSE(with_parts({{"a", 0, 4, 0, 2}, {"empty", 4, 0, 2, 0}}));
  EXPECT_TRUE(with_parts({{"short", 0, 3, 0, 2}}));
  EXPECT_TRUE(with_parts({{"few triangles", 0, 4, 0, 1}}));
  EXPECT_TRUE(with_parts({{"long", 0, 5, 0, 2}}));
  EXPECT_TRUE(with_parts({{"many triangles", 0, 4, 0, 3}}));
  EXPECT_TRUE(with_parts({{"gap", 1, 3, 0, 2}}));
  EXPECT_TRUE(with_parts({{"overlap", 0, 4, 0, 1}, {"b", 3, 1, 1, 1}}));
  EXPECT_TRUE(with_parts({{"crossing", 0, 2, 0, 1}, {"b", 2, 2, 1, 1}}));
  EXPECT_TRUE(with_parts({{"huge", 0, 0xffffffffU, 0, 2}, {"b", 0xffffffffU, 5, 2, 0}}));
}

TEST(TriangleMesh, FindsPartsByName) {
  MeshSource source = square();
  source.positions.insert(source.positions.end(), {{5, 0, 0}, {6, 0, 0}, {5, 1, 0}});
  source.triangles.push_back({4, 5, 6});
  source.parts = {{"skin", 0, 4, 0, 2}, {"teeth", 4, 3, 2, 1}};
  const auto mesh = TriangleMesh::build(source).value();
  ASSERT_NE(mesh->find_part("teeth"), nullptr);
  EXPECT_EQ(mesh->find_part("teeth")->first_vertex, 4U);
  EXPECT_EQ(mesh->find_part("hair"), nullptr);
  EXPECT_EQ(mesh->component_count(), 2U);
  EXPECT_EQ(mesh->components()[3], 0U);
  EXPECT_EQ(mesh->components()[6], 1U);
}

TEST(TriangleMesh, DropsTrianglesThatRepeatAVertexAndKeepsVertexNumbers) {
  MeshSource source = square();
  source.positions.insert(source.positions.end(), {{5, 0, 0}, {6, 0, 0}, {5, 1, 0}});
  source.triangles = {{0, 0, 1}, {0, 1, 2}, {0, 2, 3}, {2, 3, 3}, {4, 5, 6}, {4, 5, 4}};
  source.parts = {{"a", 0, 4, 0, 4}, {"b", 4, 3, 4, 2}};
  const auto mesh = TriangleMesh::build(source).value();
  EXPECT_EQ(mesh->dropped_triangles(), 3U);
  EXPECT_EQ(mesh->triangle_count(), 3U);
  EXPECT_EQ(mesh->vertex_count(), 7U);
  EXPECT_EQ(mesh->parts()[0].triangle_count, 2U);
  EXPECT_EQ(mesh->parts()[1].first_triangle, 2U);
  EXPECT_EQ(mesh->parts()[1].triangle_count, 1U);
}

TEST(TriangleMesh, AThirdTriangleAtAnEdgeIsKeptAndSaid) {
  MeshSource source = square();
  EXPECT_EQ(note_of_extra_triangles(*TriangleMesh::build(source).value()), "");
  source.positions.push_back({0.5, 0.5, 1});
  source.triangles.push_back({source.triangles[0][0], source.triangles[0][1], 4});
  source.triangles.push_back({source.triangles[0][1], source.triangles[0][0], 4});
  source.parts.clear();
  const auto mesh = TriangleMesh::build(source);
  ASSERT_TRUE(mesh.ok()) << mesh.error().line();
  EXPECT_EQ((*mesh)->triangle_count(), 4U);
  EXPECT_EQ((*mesh)->vertex_count(), 5U);
  EXPECT_EQ((*mesh)->component_count(), 1U);
  EXPECT_NE(note_of_extra_triangles(**mesh).find("sheet of its own"), std::string::npos);
}

TEST(TriangleMesh, WeldsCoincidentVerticesWithinAPartOnly) {
  MeshSource source;
  // Two triangles that meet at an edge whose vertices the file repeats, as at a texture seam, and a third surface
  // apart.
  source.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0},
                      {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
  source.triangles = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
  source.parts = {{"a", 0, 6, 0, 2}, {"b", 6, 3, 2, 1}};
  const auto mesh = TriangleMesh::build(source).value();
  const std::vector<std::uint32_t> weld(mesh->weld().begin(), mesh->weld().end());
  EXPECT_EQ(weld, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 5, 6, 7, 8}));
  EXPECT_EQ(mesh->component_count(), 2U);
  EXPECT_EQ(mesh->vertex_count(), 9U) << "vertex numbers of the file stay";
}

}  // namespace
}  // namespace penpose::mesh
