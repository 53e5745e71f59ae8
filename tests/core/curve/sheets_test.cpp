#include "core/curve/sheets.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "tests/support/models/test_rigs.h"

namespace penpose::curve {
namespace {

TEST(Sheets, AWalkStaysNearTheStraightLine) {
  // A grid with a column left out: its two halves hang together nowhere.
  const auto whole = tests::grid_mesh(8, 8);
  mesh::MeshSource source;
  source.positions.assign(whole->positions().begin(), whole->positions().end());
  std::vector<std::uint32_t> left, right;
  for (const mesh::Triangle& t : whole->triangles()) {
    double x = 0;
    for (const std::uint32_t v : t) x += whole->positions()[v].x / 3;
    if (x > 0.5 && x < 0.625) continue;
    (x < 0.5 ? left : right).push_back(static_cast<std::uint32_t>(source.triangles.size()));
    source.triangles.push_back(t);
  }
  const auto mesh = mesh::TriangleMesh::build(std::move(source)).value();
  const std::vector<glm::vec3> positions(mesh->positions().begin(), mesh->positions().end());
  Sheets sheets(*mesh);
  const auto place = [&](std::uint32_t triangle) {
    ModelPoint middle{0};
    for (const std::uint32_t v : mesh->triangles()[triangle]) middle += mesh->positions()[v] / 3.0;
    return Sheets::Place{triangle, middle};
  };
  for (const std::uint32_t other : left) EXPECT_TRUE(sheets.joined(place(left.front()), place(other), 0.2, positions));
  for (const std::uint32_t other : right)
    EXPECT_FALSE(sheets.joined(place(left.front()), place(other), 10, positions)) << "however far one may stray";
}

TEST(SegmentDistance, IsTheLeastOverBothSegments) {
  tests::Random random(7);
  const auto point = [&] { return random.vector(1); };
  for (int i = 0; i < 200; ++i) {
    const ModelPoint a0 = point(), a1 = i % 7 == 0 ? a0 : point(), b0 = point(), b1 = i % 5 == 0 ? b0 : point();
    double least = 1e9;
    for (int s = 0; s <= 100; ++s) {
      for (int t = 0; t <= 100; ++t)
        least = std::min(least, geometry::distance(a0 + (a1 - a0) * (s / 100.0), b0 + (b1 - b0) * (t / 100.0)));
    }
    const double exact = segment_distance(a0, a1, b0, b1);
    EXPECT_LE(exact, least + 1e-12);
    EXPECT_NEAR(exact, least, 0.02);
  }
}

}  // namespace
}  // namespace penpose::curve
