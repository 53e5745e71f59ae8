#include "core/mesh/topology.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>
#include <tuple>

namespace penpose::mesh {
namespace {

using Numbers = std::vector<std::uint32_t>;

MeshSource source_of(std::vector<ModelPoint> positions, std::vector<Triangle> triangles) {
  MeshSource source;
  const auto vertices = static_cast<std::uint32_t>(positions.size());
  const auto count = static_cast<std::uint32_t>(triangles.size());
  source.positions = std::move(positions);
  source.triangles = std::move(triangles);
  source.parts = {{"", 0, vertices, 0, count}};
  return source;
}

TEST(Topology, SortsEdgesByEdgeThenByTriangle) {
  const std::vector<Triangle> triangles{{3, 1, 0}, {0, 1, 2}, {2, 1, 3}};
  const auto edges = sorted_edges(triangles, 4);
  std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> got;
  for (const EdgeUse& e : edges) got.emplace_back(e.low, e.high, e.triangle);
  EXPECT_EQ(got.size(), 9U);
  EXPECT_TRUE(std::is_sorted(got.begin(), got.end()));
  EXPECT_EQ(got[0], std::make_tuple(0U, 1U, 0U));
  EXPECT_EQ(got[1], std::make_tuple(0U, 1U, 1U));
  EXPECT_EQ(got[8], std::make_tuple(2U, 3U, 2U));
}

TEST(Topology, FindsTheFirstThirdTriangleAtAnEdge) {
  std::vector<Triangle> fan{{0, 1, 2}, {1, 0, 3}};
  EXPECT_FALSE(first_non_manifold_triangle(fan, 6));
  fan.push_back({2, 1, 4});
  EXPECT_FALSE(first_non_manifold_triangle(fan, 6));
  fan.push_back({0, 1, 5});
  fan.push_back({1, 2, 5});
  EXPECT_EQ(first_non_manifold_triangle(fan, 6), 3U);
  EXPECT_FALSE(first_non_manifold_triangle({}, 0));
}

TEST(Topology, AManifoldHasNoExtraTriangles) {
  const std::vector<ModelPoint> places{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_EQ(extra_triangles(std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}, places), Numbers{});
  EXPECT_EQ(extra_triangles(std::vector<Triangle>{{0, 1, 2}, {0, 2, 1}}, places), Numbers{}) << "a card with a back";
  EXPECT_EQ(extra_triangles({}, {}), Numbers{});
}

TEST(Topology, AFinIsExtraWhateverItsNumber) {
  const std::vector<ModelPoint> places{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}};
  const Triangle a{0, 1, 2}, b{0, 2, 3}, fin{0, 2, 4}, turned{2, 0, 4};
  EXPECT_EQ(extra_triangles(std::vector<Triangle>{a, b, fin}, places), Numbers{2});
  EXPECT_EQ(extra_triangles(std::vector<Triangle>{fin, a, b}, places), Numbers{0});
  EXPECT_EQ(extra_triangles(std::vector<Triangle>{a, turned, b}, places), Numbers{1});
}

TEST(Topology, OfDoubledFacesTheFirstSideIsTheSurface) {
  const std::vector<ModelPoint> places{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const Triangle a{0, 1, 2}, b{0, 2, 3}, back_a{0, 2, 1}, back_b{0, 3, 2};
  EXPECT_EQ(extra_triangles(std::vector<Triangle>{a, b, back_a, back_b}, places), (Numbers{2, 3}));
  EXPECT_EQ(extra_triangles(std::vector<Triangle>{a, back_a, b, back_b}, places), (Numbers{1, 3}));
  EXPECT_EQ(extra_triangles(std::vector<Triangle>{a, a, b, b}, places), (Numbers{1, 3}));
}

TEST(Topology, AThousandTrianglesAtAnEdgeLeaveTwo) {
  std::vector<ModelPoint> places{{0, 0, 0}, {1, 0, 0}};
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    places.push_back({0.5, 1.0 + i, 2.0});
    triangles.push_back(i % 2 == 0 ? Triangle{0, 1, 2 + i} : Triangle{1, 0, 2 + i});
  }
  const auto extra = extra_triangles(triangles, places);
  EXPECT_EQ(extra.size(), 998U);
  EXPECT_EQ(extra.front(), 2U);
}

TEST(Topology, SeamsAreWeldedBelowAFin) {
  // The two halves of a square, each with vertices of its own, and a fin on the seam of the first.
  const auto source =
      source_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 2}},
                {{0, 1, 2}, {3, 4, 5}, {1, 2, 6}, {2, 1, 7}});
  const auto extra = extra_triangles(source.triangles, source.positions);
  ASSERT_EQ(extra.size(), 1U);
  const auto weld = weld_coincident(source, extra);
  EXPECT_EQ(weld[3], 0U);
  EXPECT_EQ(weld[4], 2U);
  EXPECT_EQ(weld[6], 6U);
}

TEST(Topology, WeldsTheSeamOfASurface) {
  const auto source =
      source_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-0.0, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(weld_coincident(source), (Numbers{0, 1, 2, 0, 2, 5}));
}

TEST(Topology, LeavesTouchingThingsApartWhereAWeldWouldNotBeASurface) {
  // A lash stands on an edge that two triangles of the lid share already.
  const auto lash = source_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 0}, {1, 0, 0}, {0, 0, 1}},
                              {{0, 1, 2}, {1, 0, 3}, {4, 5, 6}});
  EXPECT_EQ(weld_coincident(lash), (Numbers{0, 1, 2, 3, 4, 5, 6}));
  // Welding would flatten this triangle to an edge.
  const auto flat = source_of({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}, {{0, 1, 2}});
  EXPECT_EQ(weld_coincident(flat), (Numbers{0, 1, 2}));
}

TEST(Topology, OnePartDoesNotKeepAnotherFromBeingWelded) {
  MeshSource source = source_of({{0, 0, 0},
                                 {1, 0, 0},
                                 {0, 0, 0},  // flat when welded
                                 {0, 0, 5},
                                 {1, 0, 5},
                                 {1, 1, 5},
                                 {0, 0, 5},
                                 {1, 1, 5},
                                 {0, 1, 5}},
                                {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}});
  source.parts = {{"flat", 0, 3, 0, 1}, {"seam", 3, 6, 1, 2}};
  EXPECT_EQ(weld_coincident(source), (Numbers{0, 1, 2, 3, 4, 5, 3, 5, 8}));
}

TEST(Topology, SmoothsOnlyWhereTheFileDoes) {
  MeshSource source =
      source_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {3, 4, 5}});
  const auto weld = weld_coincident(source);
  EXPECT_EQ(smoothing_groups(source, weld), weld) << "a file without normals is smooth";
  source.normals.assign(6, {0, 0, 1});
  EXPECT_EQ(smoothing_groups(source, weld), weld);
  source.normals[3] = {1, 0, 0};  // a crease at one end of the seam
  EXPECT_EQ(smoothing_groups(source, weld), (Numbers{0, 1, 2, 3, 2, 5}));
}

TEST(Topology, ManyCornersOfOnePlaceFallIntoGroupsByNormal) {
  // The corner of a cube, six vertices at one place, two a side: no triangle uses them, so that all are welded.
  MeshSource source = source_of(std::vector<ModelPoint>(6, {1, 1, 1}), {});
  source.normals = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}};
  const auto weld = weld_coincident(source);
  EXPECT_EQ(weld, Numbers(6, 0));
  EXPECT_EQ(smoothing_groups(source, weld), (Numbers{0, 1, 2, 1, 0, 2}));
}

TEST(Topology, NumbersComponentsByTheirLowestVertex) {
  Numbers weld(8);
  std::iota(weld.begin(), weld.end(), 0U);
  const std::vector<Triangle> triangles{{4, 6, 7}, {1, 5, 2}};
  const Components apart = label_components(triangles, weld);
  EXPECT_EQ(apart.count, 4U);
  EXPECT_EQ(apart.component, (Numbers{0, 1, 1, 2, 3, 1, 3, 3}));
  weld[7] = 2;
  const Components joined = label_components(triangles, weld);
  EXPECT_EQ(joined.count, 3U);
  EXPECT_EQ(joined.component, (Numbers{0, 1, 1, 2, 1, 1, 1, 1}));
}

}  // namespace
}  // namespace penpose::mesh
