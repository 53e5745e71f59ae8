#include "ui/render/light/baked_light.h"

#include <gtest/gtest.h>

#include "tests/support/models/render_shapes.h"

namespace penpose::render {
namespace {

class SoftLight : public EachWay {};
INSTANTIATE_TEST_SUITE_P(Ways, SoftLight, testing::ValuesIn(built_in_ways()), way_name);

/// A cup, open at the top: walls around a floor. Vertices of the floor's box come first.
document::Model cup() {
  mesh::MeshSource source;
  add_box(source, {0, 0, 0}, {1, 0.1, 1});
  for (const double side : {-1.0, 1.0}) {
    add_box(source, {side * 1.1, 1, 0}, {0.1, 1.1, 1.2});
    add_box(source, {0, 1, side * 1.1}, {1, 1.1, 0.1});
  }
  return model_of(std::move(source));
}

TEST(BakedLight, ACavityIsDarkerThanItsRim) {
  const document::Model model = cup();
  const auto light = bake_light(model, make_appearance(model));
  ASSERT_NE(light, nullptr);
  ASSERT_EQ(light->sky.size(), model.mesh->vertex_count());
  const auto positions = model.mesh->positions();
  int floor = 0;
  int rim = 255;
  for (std::size_t v = 0; v < 8; ++v) {
    if (positions[v].y > 0) floor = std::max(floor, int{light->sky[v]});
  }
  for (std::size_t v = 8; v < positions.size(); ++v) {
    if (positions[v].y > 2 && std::abs(positions[v].x) > 1.15) rim = std::min(rim, int{light->sky[v]});
  }
  EXPECT_LT(floor, rim - 40);
}

TEST(BakedLight, WhatStandsOnTheGroundShadesItThere) {
  const document::Model model = cup();
  const auto light = bake_light(model, make_appearance(model));
  ASSERT_NE(light, nullptr);
  EXPECT_NEAR(light->ground.y, -0.1F, 1e-5F);
  constexpr std::size_t k_side = BakedLight::k_ground_px;
  ASSERT_EQ(light->ground_shade.size(), k_side * k_side);
  EXPECT_GT(light->ground_shade[k_side / 2 * k_side + k_side / 2], 200) << "under it";
  EXPECT_EQ(light->ground_shade[0], 0) << "far from it";
}

TEST(BakedLight, WhoeverStopsItGetsNone) {
  const document::Model model = cup();
  const std::atomic<bool> stop = true;
  EXPECT_EQ(bake_light(model, make_appearance(model), &stop), nullptr);
}

/// The cup from above on a white ground, with its light or without.
Image cup_from_above(DrawWay way, bool shaded) {
  const Shown shown(cup());
  Appearance appearance = make_appearance(shown.model);
  if (shaded) appearance.light = bake_light(shown.model, appearance);
  Scene scene = shown.scene();
  scene.appearance = &appearance;
  scene.background = {{1, 1, 1, 1}, {1, 1, 1, 1}};
  const auto renderer = make_renderer(way);
  if (!renderer) return {};
  return renderer->render(scene, frame_points(shown.positions, {160, 160}, {20, 40})).value();
}

TEST_P(SoftLight, DarkensCavitiesAndTheGroundWhereItIsAskedFor) {
  const Image flat = cup_from_above(GetParam(), false);
  const Image soft = cup_from_above(GetParam(), true);
  int darker = 0;
  int brighter = 0;
  for (std::size_t i = 0; i < flat.pixels.size(); i += 4) {
    darker += soft.pixels[i] + 10 < flat.pixels[i] ? 1 : 0;
    brighter += soft.pixels[i] > flat.pixels[i] + 4 ? 1 : 0;
  }
  EXPECT_GT(darker, 1500);
  EXPECT_EQ(brighter, 0);
}

TEST_P(SoftLight, ABallsLightIsTheSameWhereverOneLooksFrom) {
  const Shown shown(sphere_model(1));
  const Appearance appearance = make_appearance(shown.model);
  Scene scene = shown.scene();
  scene.appearance = &appearance;
  scene.matcap = true;
  const auto renderer = make_renderer(GetParam());
  ASSERT_NE(renderer, nullptr);
  renderer->set_occlusion(false);
  const Image front = renderer->render(scene, frame_points(shown.positions, {120, 120}, {0, 0})).value();
  const Image below = renderer->render(scene, frame_points(shown.positions, {120, 120}, {140, -50})).value();
  EXPECT_LT(differing(front, below, 12), 120 * 120 / 50);
  EXPECT_GT(front.at(45, 40)[0], front.at(80, 85)[0] + 60) << "its lamp is above on the left";
}

}  // namespace
}  // namespace penpose::render
