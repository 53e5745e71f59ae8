#include <gtest/gtest.h>

#include "tests/support/models/render_shapes.h"

namespace penpose::render {
namespace {

class Looks : public EachWay {};
INSTANTIATE_TEST_SUITE_P(Ways, Looks, testing::ValuesIn(built_in_ways()), way_name);

using document::AlphaMode;
using document::TextureUse;

constexpr geometry::Viewport k_look_viewport{100, 100};

/// A picture of four quarters: red, green, blue and clear white, from the left above.
std::shared_ptr<const std::vector<std::uint8_t>> quarters() {
  Image image{8, 8, {}};
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      const bool right = x >= 4;
      const bool low = y >= 4;
      const std::array<std::uint8_t, 4> px =
          !low ? (right ? std::array<std::uint8_t, 4>{0, 255, 0, 255} : std::array<std::uint8_t, 4>{255, 0, 0, 255})
               : (right ? std::array<std::uint8_t, 4>{255, 255, 255, 0} : std::array<std::uint8_t, 4>{0, 0, 255, 255});
      image.pixels.insert(image.pixels.end(), px.begin(), px.end());
    }
  }
  return std::make_shared<const std::vector<std::uint8_t>>(encode_png(image).value());
}

/// A square that looks along +z, with the picture on it.
struct Card {
  explicit Card(DrawWay drawn) : way(drawn) {
    look.images.push_back({"card", "image/png", quarters()});
    look.surfaces.resize(1);
    look.surfaces[0].texture = TextureUse{};
    look.surfaces[0].unlit = true;
    look.surface_of = {0, 0};
    look.coordinates[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  }
  document::Surface& surface() { return look.surfaces[0]; }

  Image picture(double yaw = 0, bool clay = false) const {
    mesh::MeshSource source;
    source.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    source.triangles = {{0, 1, 2}, {0, 2, 3}};
    document::Model model = model_of(source);
    model.look = std::make_shared<const document::Look>(look);
    const Shown shown(std::move(model));
    const Appearance appearance = make_appearance(shown.model);
    Scene scene = shown.scene();
    scene.appearance = &appearance;
    scene.clay = clay;
    scene.background = {{0, 0, 0, 1}, {0, 0, 0, 1}};
    const auto renderer = make_renderer(way);
    if (!renderer) return {};
    renderer->set_occlusion(false);
    auto image = renderer->render(scene, frame_points(shown.positions, k_look_viewport, {yaw, 0})).value();
    notes = renderer->take_undrawn();
    return image;
  }

  DrawWay way;
  document::Look look;
  mutable std::vector<std::string> notes;
};

void expect_color(const Image& image, int x, int y, int r, int g, int b) {
  const std::uint8_t* px = image.at(x, y);
  EXPECT_NEAR(px[0], r, 12) << x << " " << y;
  EXPECT_NEAR(px[1], g, 12) << x << " " << y;
  EXPECT_NEAR(px[2], b, 12) << x << " " << y;
}

TEST_P(Looks, APictureIsSeenTheRightWayUp) {
  const Image image = Card(GetParam()).picture();
  expect_color(image, 30, 30, 255, 0, 0);
  expect_color(image, 70, 30, 0, 255, 0);
  expect_color(image, 30, 70, 0, 0, 255);
}

TEST_P(Looks, ClayShowsTheShapeAlone) {
  const Image image = Card(GetParam()).picture(0, true);
  for (const int x : {30, 70}) {
    const std::uint8_t* px = image.at(x, 30);
    EXPECT_NEAR(px[0], px[1], 20);
    EXPECT_GT(px[0], 60);
  }
}

TEST_P(Looks, TheFactorAndTheColoursOfVerticesMultiply) {
  Card card(GetParam());
  card.surface().base_color = {0, 1, 1, 1};
  expect_color(card.picture(), 30, 30, 0, 0, 0);
  card.surface().base_color = {1, 1, 1, 1};
  card.look.colors.assign(4, {0.5F, 1, 1, 1});
  expect_color(card.picture(), 30, 30, 188, 0, 0);
}

TEST_P(Looks, AMaskLeavesOutWhatIsClear) {
  Card card(GetParam());
  card.surface().alpha = AlphaMode::opaque;
  expect_color(card.picture(), 70, 70, 255, 255, 255);
  card.surface().alpha = AlphaMode::mask;
  const Image image = card.picture();
  expect_color(image, 70, 70, 0, 0, 0);
  expect_color(image, 30, 30, 255, 0, 0);
}

TEST_P(Looks, WhatIsBlendedLetsOneSeeThrough) {
  Card card(GetParam());
  card.surface().alpha = AlphaMode::blend;
  card.surface().base_color = {1, 1, 1, 0.5};
  const Image image = card.picture();
  expect_color(image, 30, 30, 128, 0, 0);
  expect_color(image, 70, 70, 0, 0, 0);
}

TEST_P(Looks, ThePictureIsShiftedScaledAndTurned) {
  Card card(GetParam());
  card.surface().texture->offset = {0.5, 0};
  expect_color(card.picture(), 30, 30, 0, 255, 0);
  card.surface().texture->offset = {0, 0};
  card.surface().texture->scale = {0.5, 0.5};
  for (const int x : {25, 75}) expect_color(card.picture(), x, 25, 255, 0, 0);
  // A quarter turn: u of the picture is v of the surface, and v is one less u.
  card.surface().texture->scale = {1, 1};
  card.surface().texture->rotation = 1.5707963267948966;
  const Image turned = card.picture();
  expect_color(turned, 30, 30, 0, 0, 255);
  expect_color(turned, 70, 30, 255, 0, 0);
}

TEST_P(Looks, TheSecondSetOfCoordinatesCanBeUsed) {
  Card card(GetParam());
  card.look.coordinates[1].assign(4, {0.75F, 0.25F});
  card.surface().texture->coordinates = 1;
  expect_color(card.picture(), 30, 70, 0, 255, 0);
}

TEST_P(Looks, OneSidedSurfacesAreNotSeenFromBehind) {
  Card card(GetParam());
  expect_color(card.picture(180), 30, 30, 0, 0, 0);
  card.surface().double_sided = true;
  expect_color(card.picture(180), 30, 30, 0, 255, 0);
}

TEST_P(Looks, LightFallsOnWhatIsNotUnlit) {
  Card card(GetParam());
  card.surface().unlit = false;
  const std::uint8_t* px = card.picture().at(30, 30);
  EXPECT_GT(px[0], 120);
  EXPECT_LT(px[0], 254);
  EXPECT_LT(px[1], 90);
}

TEST_P(Looks, APictureThatCannotBeReadIsGreyAndSaidOnce) {
  Card card(GetParam());
  const auto whole = card.look.images[0].bytes.view();
  std::vector<std::uint8_t> bytes(whole.begin(), whole.end());
  bytes.resize(bytes.size() / 2);
  card.look.images[0].bytes = std::make_shared<const std::vector<std::uint8_t>>(bytes);
  const Image image = card.picture();
  const std::uint8_t* px = image.at(30, 30);
  EXPECT_NEAR(px[0], px[1], 20);
  EXPECT_GT(px[0], 60);
  ASSERT_EQ(card.notes.size(), 1U);
  EXPECT_NE(card.notes[0].find("card"), std::string::npos) << card.notes[0];
}

TEST_P(Looks, TranslucentTrianglesAreSeenFromTheFarthestOn) {
  // Two half clear cards, one behind the other, given the near one first.
  mesh::MeshSource source;
  for (const double z : {0.5, 0.0}) {
    const auto first = static_cast<std::uint32_t>(source.positions.size());
    for (const auto& [x, y] : {std::pair{-1, -1}, std::pair{1, -1}, std::pair{1, 1}, std::pair{-1, 1}})
      source.positions.emplace_back(x, y, z);
    source.triangles.push_back({first, first + 1, first + 2});
    source.triangles.push_back({first, first + 2, first + 3});
  }
  document::Model model = model_of(source);
  document::Look look;
  look.surfaces.resize(1);
  look.surfaces[0].alpha = AlphaMode::blend;
  look.surfaces[0].unlit = true;
  look.surface_of.assign(4, 0);
  look.colors.assign(8, {1, 0, 0, 0.5F});
  std::fill(look.colors.begin() + 4, look.colors.end(), std::array<float, 4>{0, 1, 0, 0.5F});
  model.look = std::make_shared<const document::Look>(look);
  const Shown shown(std::move(model));
  const Appearance appearance = make_appearance(shown.model);
  Scene scene = shown.scene();
  scene.appearance = &appearance;
  scene.background = {{0, 0, 0, 1}, {0, 0, 0, 1}};
  const auto renderer = make_renderer(GetParam());
  ASSERT_NE(renderer, nullptr);
  renderer->set_occlusion(false);
  const Image image = renderer->render(scene, frame_points(shown.positions, k_look_viewport, {0, 0})).value();
  expect_color(image, 50, 50, 128, 64, 0);
}

}  // namespace
}  // namespace penpose::render
