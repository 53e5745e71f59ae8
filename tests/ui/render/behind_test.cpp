#include <gtest/gtest.h>

#include "tests/support/models/render_shapes.h"
namespace penpose::render {
namespace {

constexpr geometry::Viewport k_viewport{200, 100};

class BehindTheModel : public EachWay {
 protected:
  void SetUp() override {
    renderer = make_renderer(GetParam());
    ASSERT_NE(renderer, nullptr);
  }
  std::unique_ptr<Renderer> renderer;
  const geometry::Camera camera = geometry::Camera::make({}, k_viewport).value();
};
INSTANTIATE_TEST_SUITE_P(Ways, BehindTheModel, testing::ValuesIn(built_in_ways()), way_name);

std::shared_ptr<const Image> plain(std::uint8_t top, std::uint8_t bottom) {
  auto image = std::make_shared<Image>(Image{8, 8, {}});
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      const std::uint8_t value = y < 4 ? top : bottom;
      image->pixels.insert(image->pixels.end(), {value, 0, 255, 255});
    }
  }
  return image;
}

TEST_P(BehindTheModel, ThePictureStandsWhereItsCornersAreWithItsTopAbove) {
  const Image before = renderer->render({}, camera).value();
  renderer->set_behind({plain(200, 50), {40, 20}, {120, 60}, 1});
  const Image image = renderer->render({}, camera).value();
  EXPECT_NEAR(image.at(80, 24)[0], 200, 2);
  EXPECT_NEAR(image.at(80, 55)[0], 50, 2);
  EXPECT_EQ(image.at(80, 24)[2], 255);
  for (const auto& [x, y] : {std::pair{30, 30}, std::pair{130, 30}, std::pair{80, 10}, std::pair{80, 70}})
    EXPECT_TRUE(std::equal(image.at(x, y), image.at(x, y) + 4, before.at(x, y))) << x << " " << y;
  // Taken away it leaves nothing.
  renderer->set_behind({});
  EXPECT_EQ(renderer->render({}, camera).value(), before);
}

TEST_P(BehindTheModel, HalfOfItShowsAtHalfItsOpacity) {
  const Image before = renderer->render({}, camera).value();
  renderer->set_behind({plain(200, 200), {0, 0}, {200, 100}, 0.5F});
  const Image image = renderer->render({}, camera).value();
  EXPECT_NEAR(image.at(100, 50)[0], 0.5 * (200 + before.at(100, 50)[0]), 3);
}

TEST_P(BehindTheModel, TheModelIsInFrontOfIt) {
  const Shown shown(sphere_model(1));
  const auto near = frame_points(shown.positions, k_viewport);
  const Image alone = renderer->render(shown.scene(), near).value();
  renderer->set_behind({plain(200, 200), {0, 0}, {200, 100}, 1});
  const Image image = renderer->render(shown.scene(), near).value();
  EXPECT_TRUE(std::equal(image.at(100, 50), image.at(100, 50) + 4, alone.at(100, 50)));
  EXPECT_NEAR(image.at(5, 5)[0], 200, 2);
}

}  // namespace
}  // namespace penpose::render
