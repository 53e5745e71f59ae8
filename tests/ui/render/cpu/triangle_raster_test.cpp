#include "ui/render/cpu/triangles/triangle_raster.h"

#include <gtest/gtest.h>
#include <map>
#include <random>

namespace penpose::render {
namespace {

using Px = std::map<std::pair<int, int>, int>;

Corners with_the_clock(Corners corners) {
  if (twice_area(corners) < 0) std::swap(corners[1], corners[2]);
  return corners;
}

void count(const Corners& corners, const PxRect& within, Px& px) {
  if (twice_area(corners) == 0) return;
  visit_inside(with_the_clock(corners), within, [&](int x, int y) { ++px[{x, y}]; });
}

TEST(TriangleRaster, TrianglesThatShareEdgesTakeEachPxOnce) {
  std::mt19937 random(3);  // NOLINT(cert-msc51-cpp): the same numbers each time
  for (const int size : {20, 60, 400}) {
    const PxRect within{0, 0, size, size};
    const std::int32_t whole = size * k_subpixels;
    for (int round = 0; round < 50; ++round) {
      // A square around any point in it: four triangles.
      const auto somewhere = [&] { return static_cast<std::int32_t>(random() % static_cast<unsigned>(whole)); };
      Corner middle{somewhere(), somewhere(), 0};
      if (round % 5 == 0) middle.x = middle.x / k_subpixels * k_subpixels + k_subpixels / 2;  // through middles of px
      const Corner square[4] = {{0, 0, 0}, {whole, 0, 0}, {whole, whole, 0}, {0, whole, 0}};
      Px px;
      for (int k = 0; k < 4; ++k) count({middle, square[k], square[(k + 1) % 4]}, within, px);
      EXPECT_EQ(px.size(), static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
      for (const auto& [at, times] : px) EXPECT_EQ(times, 1) << at.first << " " << at.second;
    }
  }
}

TEST(TriangleRaster, RowsHaveThePxThatOneByOneAreInside) {
  std::mt19937 random(4);  // NOLINT(cert-msc51-cpp): the same numbers each time
  const PxRect within{3, 2, 90, 70};
  for (int round = 0; round < 300; ++round) {
    const auto somewhere = [&] { return static_cast<std::int32_t>(random() % 40000U) - 8000; };
    const Corners corners = with_the_clock(
        {Corner{somewhere(), somewhere(), 0}, {somewhere(), somewhere(), 0}, {somewhere(), somewhere(), 0}});
    if (twice_area(corners) == 0) continue;
    Px rows;
    visit_rows(corners, within, [&](int left, int right, int y) {
      for (int x = left; x < right; ++x) ++rows[{x, y}];
    });
    Px single;
    internal::visit_px<std::int64_t>(corners, within, [&](int x, int y) { ++single[{x, y}]; });
    EXPECT_EQ(rows, single);
  }
}

TEST(TriangleRaster, DepthIsThatOfTheCornersAndRunsStraightBetween) {
  const Corners corners{{{0, 0, 1.0F}, {40 * k_subpixels, 0, 3.0F}, {0, 20 * k_subpixels, 2.0F}}};
  const PxPlane plane = depth_plane(corners, twice_area(corners));
  EXPECT_NEAR(plane.at(0, 0), 1 + 0.5 * 2 / 40 + 0.5 * 1 / 20, 1e-5);
  EXPECT_NEAR(plane.at(20, 5), 1 + 20.5 * 2 / 40 + 5.5 * 1 / 20, 1e-5);
}

}  // namespace
}  // namespace penpose::render
