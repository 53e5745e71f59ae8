#include "ui/app/view/present/output/rotation.h"

#include <gtest/gtest.h>

namespace penpose::app {
namespace {

render::Image numbered(int width, int height) {
  render::Image picture{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(4 * width * height))};
  for (std::size_t i = 0; i < picture.pixels.size(); i += 4) picture.pixels[i] = static_cast<std::uint8_t>(i / 4);
  return picture;
}

constexpr Rotation k_all[] = {Rotation::none, Rotation::quarter, Rotation::half, Rotation::three_quarters};

TEST(Rotation, AQuarterTurnPutsTheUpperLeftCornerToTheUpperRight) {
  const render::Image picture = numbered(3, 2);
  render::Image panel;
  turn(picture, {{0, 0, 3, 2}}, Rotation::quarter, panel);
  EXPECT_EQ(panel.width, 2);
  EXPECT_EQ(panel.height, 3);
  EXPECT_EQ(panel.at(1, 0)[0], 0);
  EXPECT_EQ(panel.at(1, 2)[0], 2);
  EXPECT_EQ(panel.at(0, 0)[0], 3);
}

TEST(Rotation, AFingerOnThePanelIsWhereThePictureShowsThatPixel) {
  const render::Image picture = numbered(5, 3);
  for (const Rotation rotation : k_all) {
    render::Image panel;
    turn(picture, {{0, 0, 5, 3}}, rotation, panel);
    const geometry::Viewport size = turned_size({5, 3}, rotation);
    for (int y = 0; y < panel.height; ++y) {
      for (int x = 0; x < panel.width; ++x) {
        const geometry::PxPoint at = on_picture({x + 0.5, y + 0.5}, size, rotation);
        EXPECT_EQ(panel.at(x, y)[0], picture.at(static_cast<int>(at.x), static_cast<int>(at.y))[0]);
      }
    }
  }
}

TEST(Rotation, APartIsPutWhereItWouldBeInTheWhole) {
  const render::Image picture = numbered(5, 3);
  for (const Rotation rotation : k_all) {
    render::Image whole;
    turn(picture, {{0, 0, 5, 3}}, rotation, whole);
    const render::PxRect part{1, 1, 4, 2};
    render::Image panel;
    turn(picture, {part}, rotation, panel);
    const render::PxRect there = on_panel(part, {5, 3}, rotation);
    for (int y = there.top; y < there.bottom; ++y) {
      for (int x = there.left; x < there.right; ++x) EXPECT_EQ(panel.at(x, y)[0], whole.at(x, y)[0]);
    }
    EXPECT_EQ((there.right - there.left) * (there.bottom - there.top), 3);
  }
  EXPECT_FALSE(rotation_of(45));
}

}  // namespace
}  // namespace penpose::app
