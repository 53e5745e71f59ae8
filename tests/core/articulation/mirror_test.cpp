#include "core/articulation/mirror.h"

#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/models/articulation_models.h"

namespace penpose::articulation {
namespace {

using tests::Eye;

TEST(Mirror, NamesTheOtherSide) {
  for (const auto& [name, other] : std::vector<std::pair<std::string, std::string>>{
           {"blink_L", "blink_R"},
           {"blink_R", "blink_L"},
           {"brow_l_outer", "brow_r_outer"},
           {"lid.R.001", "lid.L.001"},
           {"LeftCheek", "RightCheek"},
           {"mouthSmileRight", "mouthSmileLeft"},
           {"left lid", "right lid"},
           {"LEFT_LID", "RIGHT_LID"},
           {"lidLeft2", "lidRight2"},
           {"bright_L", "bright_R"},  // right within a word names no side
           {"cleft_chin", "cleft_chin_mirrored"},
           {"leftover", "leftover_mirrored"},
           {"jaw", "jaw_mirrored"},
           {"Lid", "Lid_mirrored"},  // nor does an L
       })
    EXPECT_EQ(mirrored_name(name), other) << name;
}

/// Two eyes, one the mirror image of the other.
std::shared_ptr<const Canvas> pair_of_eyes(const Eye& eye, double shift) {
  mesh::MeshSource source;
  for (const double side : {1.0, -1.0}) {
    tests::add_grid(source, side > 0 ? "skin_L" : "skin_R", Eye::k_rings, Eye::k_columns, true,
                    [&](std::uint32_t r, std::uint32_t c) {
                      ModelPoint p = eye.lid(r, c) + ModelVector{1.5, 0, 0};
                      return ModelPoint(shift + side * p.x, p.y, p.z);
                    });
  }
  return tests::canvas_of(std::move(source));
}

TEST(Mirror, TheLeftLidMakesTheRightLidAndBackAgain) {
  Eye eye = tests::make_eye();
  for (const double shift : {0.0, 7.0}) {
    const auto canvas = pair_of_eyes(eye, shift);
    Sketch sketch = eye.blink();
    sketch.camera.eye.x += 1.5 + shift;
    sketch.camera.look_at.x += 1.5 + shift;
    sketch.surface = Sphere{eye.center + ModelVector{1.5 + shift, 0, 0}, eye.radius};
    const auto left = build_deformer(sketch, *canvas).value();
    const auto plane = find_symmetry_plane(*canvas).value();
    EXPECT_NEAR(plane.x, shift, 1e-6);
    const auto right = mirror_deformer(*left, *canvas).value();
    EXPECT_EQ(right->sketch().name, "blink_R");
    EXPECT_EQ(right->mode(), left->mode());
    ASSERT_EQ(left->vertices().size(), right->vertices().size());
    const std::vector<ModelVector> a = left->displacements(0.6);
    const std::vector<ModelVector> b = right->displacements(0.6);
    const std::uint32_t other_side = Eye::k_rings * Eye::k_columns;
    // Positions are floats; where the plane is not at 0 those of the two sides round differently.
    const double rounding = shift == 0.0 ? 1e-6 : 1e-4;
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(right->vertices()[i], left->vertices()[i] + other_side);
      EXPECT_NEAR(right->weights()[i], left->weights()[i], rounding);
      EXPECT_LT(geometry::distance(b[i], {-a[i].x, a[i].y, a[i].z}), rounding);
    }
    const Sketch back = mirrored(mirrored(sketch, plane), plane);
    EXPECT_EQ(back.name, sketch.name);
    for (std::size_t i = 0; i < sketch.general.size(); ++i) {
      EXPECT_LT(geometry::distance(back.general[i], sketch.general[i]), 1e-9);
    }
  }
}

TEST(Mirror, ReflectsPartsAndCamerasOfTheirOwn) {
  Sketch sketch = tests::make_eye().blink();
  sketch.surface = PartSurface{"eye_L"};
  sketch.target_camera = geometry::CameraPose{{3, 1, 4}, {1, 0, 0}, {0.1, 1, 0}, 25};
  const Sketch other = mirrored(sketch, {0.5});
  EXPECT_EQ(std::get<PartSurface>(other.surface).part, "eye_R");
  EXPECT_EQ(other.target_camera->eye, ModelPoint(-2, 1, 4));
  EXPECT_EQ(other.target_camera->look_at, ModelPoint(0, 0, 0));
  EXPECT_EQ(other.target_camera->up, ModelVector(-0.1, 1, 0));
  sketch.surface = PartSurface{"skull"};
  EXPECT_EQ(std::get<PartSurface>(mirrored(sketch, {0}).surface).part, "skull");
}

TEST(Mirror, AModelWithoutSymmetryHasNoPlane) {
  mesh::MeshSource source;
  tests::add_grid(source, "ramp", 20, 20, false,
                  [](std::uint32_t r, std::uint32_t c) { return ModelPoint(c * 0.1, r * 0.1, c * c * 0.02); });
  const auto plane = find_symmetry_plane(*tests::canvas_of(std::move(source)));
  ASSERT_FALSE(plane.ok());
  EXPECT_FALSE(plane.error().remedy.empty());
}

}  // namespace
}  // namespace penpose::articulation
