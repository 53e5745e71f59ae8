#include <gtest/gtest.h>
#include <set>

#include "tests/support/models/render_shapes.h"

namespace penpose::render {
namespace {

class Toons : public EachWay {};
INSTANTIATE_TEST_SUITE_P(Ways, Toons, testing::ValuesIn(built_in_ways()), way_name);

constexpr geometry::Viewport k_toon_viewport{160, 160};

/// A yellow ball whose shade is red, without antialiasing at its tones' edge being wide.
struct ToonBall {
  explicit ToonBall(DrawWay drawn) : way(drawn) {
    document::Surface surface;
    surface.base_color = {1, 1, 0, 1};
    surface.toon = document::Toon{};
    surface.toon->shade_color = {1, 0, 0};
    surface.toon->toony = 1;
    look.surfaces = {surface};
  }

  Image picture() const {
    document::Model model = sphere_model(1);
    document::Look made = look;
    made.surface_of.assign(model.mesh->triangle_count(), 0);
    model.look = std::make_shared<const document::Look>(made);
    const Shown shown(std::move(model));
    const Appearance appearance = make_appearance(shown.model);
    Scene scene = shown.scene();
    scene.appearance = &appearance;
    scene.background = {{0, 0, 0, 1}, {0, 0, 0, 1}};
    const auto renderer = make_renderer(way);
    if (!renderer) return {};
    renderer->set_occlusion(false);
    return renderer->render(scene, frame_points(shown.positions, k_toon_viewport, {0, 0})).value();
  }

  DrawWay way;
  document::Look look;
};

int px_near(const Image& image, int r, int g, int b) {
  int count = 0;
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
    const auto far = [&](std::size_t c, int value) { return std::abs(image.pixels[i + c] - value) > 8; };
    count += far(0, r) || far(1, g) || far(2, b) ? 0 : 1;
  }
  return count;
}

TEST_P(Toons, ABallHasTwoTonesAndHardlyAnythingBetween) {
  const Image image = ToonBall(GetParam()).picture();
  const int light = px_near(image, 255, 255, 0);
  const int shade = px_near(image, 255, 0, 0);
  EXPECT_GT(light, 2000);
  EXPECT_GT(shade, 1000);
  const int covered = k_toon_viewport.width * k_toon_viewport.height - px_near(image, 0, 0, 0);
  EXPECT_GT(light + shade, covered * 9 / 10);
}

TEST_P(Toons, TheShiftMovesTheEdgeOfTheTones) {
  ToonBall ball(GetParam());
  const int before = px_near(ball.picture(), 255, 255, 0);
  ball.look.surfaces[0].toon->shift = 0.5;
  EXPECT_GT(px_near(ball.picture(), 255, 255, 0), before + 1000);
}

TEST_P(Toons, AnOutlineRunsAroundIt) {
  ToonBall ball(GetParam());
  document::Toon& toon = *ball.look.surfaces[0].toon;
  toon.outline_color = {0, 0, 1};
  toon.outline_mix = 0;
  toon.outline_width = 0.06;
  EXPECT_EQ(px_near(ball.picture(), 0, 0, 255), 0) << "a width alone draws none";
  const Image plain = ball.picture();
  toon.outline = document::OutlineWidth::world;
  const Image lined = ball.picture();
  EXPECT_GT(px_near(lined, 0, 0, 255), 300);
  EXPECT_NEAR(px_near(lined, 255, 255, 0), px_near(plain, 255, 255, 0), 40) << "around it, not over it";
  toon.outline = document::OutlineWidth::screen;
  toon.outline_width = 0.02;
  EXPECT_GT(px_near(ball.picture(), 0, 0, 255), 300);
}

}  // namespace
}  // namespace penpose::render
