#include "core/curve/sheet_line.h"

#include <cmath>
#include <gtest/gtest.h>

#include "tests/support/models/plates.h"
#include "tests/support/models/test_rigs.h"

namespace penpose::curve {
namespace {

/// A surface that is a strip bent in the plane x = const: the profile (y, z) swept from x = 0 to x = 1 in columns.
std::shared_ptr<const mesh::TriangleMesh> swept(const std::vector<std::vector<std::array<double, 2>>>& profiles,
                                                std::uint32_t columns = 20) {
  mesh::MeshSource source;
  for (const auto& profile : profiles) {
    const auto first = static_cast<std::uint32_t>(source.positions.size());
    const auto rows = static_cast<std::uint32_t>(profile.size());
    for (std::uint32_t c = 0; c <= columns; ++c) {
      for (const auto& [y, z] : profile) source.positions.emplace_back(static_cast<double>(c) / columns, y, z);
    }
    for (std::uint32_t c = 0; c < columns; ++c) {
      for (std::uint32_t r = 0; r + 1 < rows; ++r) {
        const std::uint32_t a = first + c * rows + r, b = a + rows;
        source.triangles.push_back({a, b, b + 1});
        source.triangles.push_back({a, b + 1, a + 1});
      }
    }
  }
  return mesh::TriangleMesh::build(std::move(source)).value();
}

struct Look : tests::Look {
  using tests::Look::Look;
  ProjectedStroke draw(const std::vector<PxPoint>& line) { return sheet_curve(line, 32, camera, surface()).value(); }
};

/// Along x at a height, with a wave: of so many px, over and under.
std::vector<PxPoint> wavy(double y_px, double wave_px, double from = 300, double to = 700) {
  std::vector<PxPoint> line;
  for (int i = 0; i <= 80; ++i) {
    const double x = from + (to - from) * i / 80.0;
    const int phase = (i / 8) % 4;
    line.push_back({x, y_px + wave_px * (phase == 0 ? 1 : phase == 2 ? -1 : 0.3)});
  }
  return line;
}

/// Two lips that meet at y = 0.5: each goes on inwards 0.1 deep before it turns away, and far behind they are one.
std::vector<std::array<double, 2>> lips() {
  return {{0.0, 0.0},    {0.3, 0.0},  {0.45, 0.0}, {0.49, -0.01}, {0.499, -0.03}, {0.499, -0.1},
          {0.42, -0.12}, {0.4, -0.3}, {0.6, -0.3}, {0.58, -0.12}, {0.501, -0.1},  {0.501, -0.03},
          {0.51, -0.01}, {0.55, 0.0}, {0.7, 0.0},  {1.0, 0.0}};
}

TEST(SheetCurve, MouthLineStaysOnTheLipThatMostOfItIsOn) {
  Look look(swept({lips()}));
  for (const double side : {-1.0, 1.0}) {
    const auto drawn = look.draw(wavy(500 + 2 * side, 4));
    EXPECT_EQ(drawn.dropped, 0U);
    ASSERT_EQ(drawn.positions.size(), 32U);
    for (const ModelPoint& p : drawn.positions) {
      EXPECT_GT(side < 0 ? p.y - 0.5 : 0.5 - p.y, 0) << "px grow downwards: the upper lip first";
      EXPECT_NEAR(p.y, 0.5, 0.03);
    }
    EXPECT_NEAR(drawn.positions.front().x, 0.1, 0.001 * k_stick_px * 2);
    EXPECT_NEAR(drawn.positions.back().x, 0.9, 0.001 * k_stick_px * 2);
  }
}

TEST(SheetCurve, AFlatLineAlongTheLipKeepsItsCorners) {
  Look look(swept({lips()}));
  // On the lower lip, but for the corners, which lie as far above the seam as a hand is off where a face is large.
  std::vector<PxPoint> line;
  for (int i = 0; i <= 80; ++i) {
    const double s = i / 40.0 - 1;
    line.push_back({500 + 200 * s, 512 - 36 * s * s * s * s});
  }
  const auto drawn = look.draw(line);
  EXPECT_EQ(drawn.dropped, 0U);
  EXPECT_NEAR(drawn.positions.front().x, 0.1, 0.001 * k_stick_px * 2);
  EXPECT_NEAR(drawn.positions.back().x, 0.9, 0.001 * k_stick_px * 2);
  const bool lower = drawn.positions[16].y < 0.5;
  for (const ModelPoint& p : drawn.positions) EXPECT_EQ(p.y < 0.5, lower) << "all of it is on one lip";
}

TEST(SheetCurve, RimIsMetFromInsideTheHole) {
  // A lid's rim at y = 0.4, and the back of the head behind the hole.
  Look look(swept({{{0.0, 0.0}, {0.2, 0.0}, {0.4, 0.0}}, {{1.0, -2.0}, {0.5, -2.0}, {0.0, -2.0}}}));
  const auto drawn = look.draw(wavy(549, 4));
  EXPECT_EQ(drawn.dropped, 0U);
  for (const ModelPoint& p : drawn.positions) {
    EXPECT_NEAR(p.z, 0, 1e-6) << "on the lid and not at the back of the head";
    EXPECT_LE(p.y, 0.4 + 1e-9);
    EXPECT_GT(p.y, 0.385);
  }
}

TEST(SheetCurve, KnowsHowFarBesideThePenItSticks) {
  Look look(swept({{{0.0, 0.0}, {0.2, 0.0}, {0.4, 0.0}}, {{1.0, -2.0}, {0.5, -2.0}, {0.0, -2.0}}}));
  const auto line = wavy(549, 4);
  const auto drawn = look.draw(line);
  ASSERT_EQ(drawn.aside.size(), drawn.positions.size());
  for (std::size_t i = 0; i < drawn.positions.size(); ++i) {
    const PxPoint pen = look.camera.project(drawn.positions[i] + drawn.aside[i]).value();
    double nearest = 1e9;
    for (const PxPoint& p : line) nearest = std::min(nearest, geometry::distance(p, pen));
    EXPECT_LT(nearest, 4) << "samples of the line are 5 px apart";
  }
  EXPECT_TRUE(look.draw(wavy(600, 4)).aside.empty()) << "on the lid itself it lies under the pen";
}

TEST(SheetCurve, RunsOnBehindWhatOnlyCrossesIt) {
  // A strand of hair in front of a sheet: over a fifth of the line.
  mesh::MeshSource source;
  const auto wall = tests::grid_mesh(10, 10);
  source.positions.assign(wall->positions().begin(), wall->positions().end());
  source.triangles.assign(wall->triangles().begin(), wall->triangles().end());
  tests::add_plate(source, 0.45, 0.55, 0.0, 1.0, 0.2);
  Look look(mesh::TriangleMesh::build(std::move(source)).value());
  const auto drawn = look.draw(wavy(500, 5));
  EXPECT_EQ(drawn.dropped, 0U);
  for (const ModelPoint& p : drawn.positions) EXPECT_NEAR(p.z, 0, 1e-6);
}

TEST(SheetCurve, AModelThatIsWoundInsideOutIsDrawnOnWhereItIsSeen) {
  auto front = swept({{{0.0, 0.0}, {0.5, 0.0}, {1.0, 0.0}}, {{1.0, -2.0}, {0.5, -2.0}, {0.0, -2.0}}});
  mesh::MeshSource source;
  source.positions.assign(front->positions().begin(), front->positions().end());
  for (const mesh::Triangle& t : front->triangles()) source.triangles.push_back({t[0], t[2], t[1]});
  Look look(mesh::TriangleMesh::build(std::move(source)).value());
  const auto drawn = look.draw(wavy(500, 5));
  for (const ModelPoint& p : drawn.positions) EXPECT_NEAR(p.z, 0, 1e-6);
}

TEST(SheetCurve, OneSheetIsDrawnOnAsEver) {
  Look look(tests::grid_mesh(8, 8));
  const auto line = wavy(500, 20);
  const auto drawn = look.draw(line);
  const auto before = surface_curve(line, 32, look.camera, look.tree).value();
  EXPECT_EQ(drawn.points, before.points);
}

TEST(SheetCurve, KeepsTheLongestPartWhereItLeavesTheSheet) {
  // Two plates far behind each other, side by side: no sheet under all of the line.
  mesh::MeshSource source;
  tests::add_plate(source, 0.0, 0.65, 0.0, 1.0, 0.0);
  tests::add_plate(source, 0.65, 1.0, 0.0, 1.0, -0.6);
  Look look(mesh::TriangleMesh::build(std::move(source)).value());
  const auto drawn = look.draw(wavy(500, 3));
  EXPECT_GT(drawn.dropped, 10U);
  for (const ModelPoint& p : drawn.positions) EXPECT_NEAR(p.z, 0, 1e-6);
}

TEST(SheetCurve, WhatNeverTouchesIsRefused) {
  Look look(tests::grid_mesh(4, 4));
  const SheetSurface surface{look.tree, look.positions, look.mesh->triangles(), look.sheets};
  EXPECT_FALSE(sheet_curve(std::vector<PxPoint>{{1, 1}, {40, 1}}, 32, look.camera, surface));
  EXPECT_FALSE(sheet_curve(std::vector<PxPoint>{}, 32, look.camera, surface));
  EXPECT_FALSE(sheet_curve(std::vector<PxPoint>{{500, 500}, {500, 500}}, 32, look.camera, surface));
}

}  // namespace
}  // namespace penpose::curve
