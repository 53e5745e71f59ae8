#include "core/articulation/region/region.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "core/geometry/lasso.h"
#include "tests/support/models/articulation_models.h"

namespace penpose::articulation {
namespace {

using tests::Eye;

geometry::Camera camera_of(const Eye& eye) { return geometry::Camera::make(eye.camera, eye.viewport).value(); }

TEST(Region, TakesThePieceNearestToTheCameraAndNothingBehindIt) {
  // Two walls, one behind the other; the lasso covers both.
  mesh::MeshSource source;
  for (const double z : {0.0, -2.0}) {
    tests::add_grid(source, z == 0.0 ? "front" : "back", 10, 10, false,
                    [&](std::uint32_t r, std::uint32_t c) { return ModelPoint(c * 0.1, r * 0.1, z); });
  }
  const auto canvas = tests::canvas_of(std::move(source));
  const auto camera = geometry::Camera::make({{0.45, 0.45, 5}, {0.45, 0.45, 0}, {0, 1, 0}, 30}, {}).value();
  const auto region = general_region(*canvas, camera, std::vector<PxPoint>{{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}});
  ASSERT_TRUE(region.ok());
  EXPECT_EQ(region->vertices.size(), 100U);
  EXPECT_TRUE(std::all_of(region->vertices.begin(), region->vertices.end(), [](auto v) { return v < 100; }));
}

TEST(Region, TakesHiddenVerticesOfTheSamePiece) {
  const tests::Trunk trunk = tests::make_trunk();
  const auto camera = geometry::Camera::make(trunk.camera, trunk.viewport).value();
  const auto region = general_region(*trunk.canvas, camera, trunk.box(1, 3.5, 0.6)).value();
  std::size_t behind = 0;
  for (const std::uint32_t v : region.vertices) behind += trunk.canvas->positions()[v].z < -0.1 ? 1 : 0;
  EXPECT_GT(behind, 100U);
}

TEST(Region, TheOtherPieceIsTheNextOne) {
  mesh::MeshSource source;
  for (const double z : {-2.0, 0.0}) {
    tests::add_grid(source, z == 0.0 ? "front" : "back", 10, 10, false,
                    [&](std::uint32_t r, std::uint32_t c) { return ModelPoint(c * 0.1, r * 0.1, z); });
  }
  const auto canvas = tests::canvas_of(std::move(source));
  const auto camera = geometry::Camera::make({{0.45, 0.45, 5}, {0.45, 0.45, 0}, {0, 1, 0}, 30}, {}).value();
  const std::vector<PxPoint> all{{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}};
  const auto near = general_region(*canvas, camera, all).value();
  EXPECT_EQ(near.pieces, 2U);
  EXPECT_GE(near.vertices.front(), 100U);
  const auto far = general_region(*canvas, camera, all, {}, Borders::measured, {Reach::through, 1}).value();
  EXPECT_LT(far.vertices.back(), 100U);
  EXPECT_EQ(general_region(*canvas, camera, all, {}, Borders::measured, {Reach::through, 2}).error().place, "piece");
  // What is hidden behind the first piece is not seen at all.
  const auto seen = general_region(*canvas, camera, all, {}, Borders::measured, {Reach::front, 0}).value();
  EXPECT_EQ(seen.vertices.size(), 100U);
  EXPECT_GE(seen.vertices.front(), 100U);
}

TEST(Region, TheFrontAloneLeavesWhatIsNotSeen) {
  const tests::Trunk trunk = tests::make_trunk();
  const auto camera = geometry::Camera::make(trunk.camera, trunk.viewport).value();
  const auto lasso = trunk.box(1, 3.5, 0.6);
  const auto through = general_region(*trunk.canvas, camera, lasso).value();
  const auto front = general_region(*trunk.canvas, camera, lasso, {}, Borders::measured, {Reach::front, 0}).value();
  EXPECT_GT(front.vertices.size(), through.vertices.size() / 3);
  EXPECT_LT(front.vertices.size(), 2 * through.vertices.size() / 3);
  for (const std::uint32_t v : front.vertices) EXPECT_GT(trunk.canvas->positions()[v].z, -0.12) << v;
  EXPECT_TRUE(
      std::includes(through.vertices.begin(), through.vertices.end(), front.vertices.begin(), front.vertices.end()));
}

TEST(Region, IgnoresScrapsNearerToTheCamera) {
  mesh::MeshSource source;
  tests::add_grid(source, "wall", 10, 10, false,
                  [](std::uint32_t r, std::uint32_t c) { return ModelPoint(c * 0.1, r * 0.1, 0); });
  tests::add_grid(source, "scrap", 2, 5, false,
                  [](std::uint32_t r, std::uint32_t c) { return ModelPoint(c * 0.1, r * 0.1, 1); });
  const auto canvas = tests::canvas_of(std::move(source));
  const auto camera = geometry::Camera::make({{0.45, 0.45, 5}, {0.45, 0.45, 0}, {0, 1, 0}, 30}, {}).value();
  const std::vector<PxPoint> all = {{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}};
  EXPECT_EQ(general_region(*canvas, camera, all)->vertices.size(), 100U);
  // Around the scrap alone there is nothing to take; ten vertices are too few, and so it is said.
  const auto only =
      general_region(*canvas, camera, std::vector<PxPoint>{{480, 480}, {520, 480}, {520, 520}, {480, 520}});
  ASSERT_FALSE(only.ok());
  EXPECT_NE(only.error().what.find("10"), std::string::npos);
}

TEST(Region, NeverTakesTheSurfaceThatItSlidesOver) {
  const Eye eye = tests::make_eye();
  // A lasso that reaches well into the open eye, where the ball is nearer to the camera than the lid.
  const auto lasso = eye.around(
      55, [](double a) { return Eye::margin(a, 4) - 0.5; }, [](double a) { return 50 - a * a / 70; });
  const auto without = general_region(*eye.canvas, camera_of(eye), lasso).value();
  EXPECT_GE(without.vertices.front(), Eye::k_rings * Eye::k_columns);
  for (const Surface& surface : {Surface(Sphere{eye.center, eye.radius}), Surface(PartSurface{"ball_L"})}) {
    const auto kept = KeptSurface::make(surface, *eye.canvas).value();
    const auto region = general_region(*eye.canvas, camera_of(eye), lasso, kept).value();
    EXPECT_LT(region.vertices.back(), Eye::k_rings * Eye::k_columns);
  }
}

TEST(Region, WeighsOneInsideZeroAtTheBorderAndContinuouslyBetween) {
  const Eye eye = tests::make_eye();
  const Sketch sketch = eye.blink();
  const auto kept = KeptSurface::make(sketch.surface, *eye.canvas).value();
  const auto region = general_region(*eye.canvas, camera_of(eye), sketch.general, kept).value();
  const auto weights = specific_region(region, sketch.specific).value();
  const auto general = geometry::Lasso::make(sketch.general).value();
  const auto specific = geometry::Lasso::make(sketch.specific).value();
  for (std::size_t i = 0; i < region.vertices.size(); ++i) {
    const double w = weights.weights[i];
    const double g = general.distance(region.seen[i]);
    const double c = specific.distance(region.seen[i]);
    EXPECT_DOUBLE_EQ(region.border_px[i], g);
    if (specific.contains(region.seen[i])) {
      EXPECT_EQ(w, 1.0);
    } else {
      EXPECT_DOUBLE_EQ(w, g / (g + c));
    }
    // Just inside the border hardly anything moves; just outside the specific region nearly all does.
    EXPECT_TRUE(g >= 0.01 * c || w < 0.01);
    EXPECT_TRUE(c >= 0.01 * g || w > 0.99);
  }
}

TEST(Region, SaysWhyThereIsNone) {
  const Eye eye = tests::make_eye();
  const auto camera = camera_of(eye);
  EXPECT_FALSE(general_region(*eye.canvas, camera, std::vector<PxPoint>{{0, 0}, {9, 0}, {0, 9}}).ok());
  EXPECT_FALSE(general_region(*eye.canvas, camera, std::vector<PxPoint>{{0, 0}, {9, 0}}).ok());
  const auto region = general_region(*eye.canvas, camera, eye.blink().general).value();
  EXPECT_FALSE(specific_region(region, std::vector<PxPoint>{{0, 0}, {9, 0}, {0, 9}}).ok());
}

}  // namespace
}  // namespace penpose::articulation
