#include "ui/film/contact_sheet.h"

#include <gtest/gtest.h>
#include <set>

#include "ui/film/frame_number.h"

namespace penpose::film {
namespace {

render::Image filled(int width, int height, std::uint8_t grey) {
  render::Image image{width, height, {}};
  image.pixels.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4, grey);
  return image;
}

/// How many px of a part are lighter than the ground of a sheet and darker pictures.
int light_px(const render::Image& image, int left, int top, int right, int bottom) {
  int count = 0;
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) count += image.at(x, y)[0] > 150 ? 1 : 0;
  }
  return count;
}

TEST(ContactSheet, HasEachPictureWithItsNumberBeneath) {
  auto sheet = ContactSheet::make(5, {80, 60});
  ASSERT_TRUE(sheet.ok());
  for (int i = 0; i < 5; ++i)
    sheet->put(static_cast<std::size_t>(i), filled(80, 60, static_cast<std::uint8_t>(60 + 10 * i)), 10 * i);
  const render::Image& image = sheet->image();
  std::set<int> greys;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const auto* px = image.at(x, y);
      if (px[0] == px[1] && px[0] >= 60 && px[0] <= 100 && px[0] % 10 == 0) greys.insert(px[0]);
    }
  }
  EXPECT_EQ(greys.size(), 5U);
  EXPECT_GT(image.width, image.height);
  EXPECT_EQ(light_px(image, 8, 8, 88, 68), 0) << "numbers are beneath, not in the picture";
  EXPECT_GT(light_px(image, 8, 68, 88, 86), 5);
}

TEST(ContactSheet, ThatIsTooLargeIsRefusedWithWhatToDo) {
  EXPECT_FALSE(ContactSheet::make(0, {80, 60}).ok());
  const auto huge = ContactSheet::make(100000, {640, 360});
  ASSERT_FALSE(huge.ok());
  EXPECT_NE(huge.error().what.find("100000"), std::string::npos);
  EXPECT_NE(huge.error().remedy.find("fewer"), std::string::npos);
}

TEST(FrameNumber, DigitsDifferAndStayOnTheirPlate) {
  std::set<std::vector<std::uint8_t>> seen;
  for (int digit = 0; digit < 10; ++digit) {
    render::Image image = filled(60, 60, 128);
    draw_number(image, digit, {30, 30, 20}, true);
    EXPECT_GT(light_px(image, 20, 18, 40, 42), 20) << digit;
    for (const auto& [x, y] : {std::pair{2, 30}, std::pair{57, 30}, std::pair{30, 2}, std::pair{30, 57}})
      EXPECT_EQ(image.at(x, y)[0], 128) << digit;
    EXPECT_LT(image.at(17, 30)[0], 100) << "dark around the digits";
    seen.insert(image.pixels);
  }
  EXPECT_EQ(seen.size(), 10U);
}

TEST(FrameNumber, IsDrawnIntoPicturesOfAnySize) {
  for (const auto& [width, height] : {std::pair{1, 1}, std::pair{20, 4}, std::pair{640, 360}}) {
    render::Image image = filled(width, height, 128);
    draw_frame_number(image, 1234567);
    EXPECT_EQ(image.pixels.size(), static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    if (width < 100) continue;
    EXPECT_GT(light_px(image, 0, height - 40, width / 2, height), 50);
    EXPECT_EQ(light_px(image, width / 2, 0, width, height), 0);
  }
}

}  // namespace
}  // namespace penpose::film
