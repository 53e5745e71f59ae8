#include "ui/render/picture/color.h"

#include <gtest/gtest.h>

namespace penpose::render {
namespace {

TEST(Color, DisplayValuesComeBack) {
  for (int i = 0; i < 256; ++i) {
    const float v = static_cast<float>(i) / 255.0F;
    EXPECT_NEAR(encode_srgb(decode_srgb(v)), v, 1e-5F) << i;
  }
  EXPECT_NEAR(from_srgb(0x808080).g, 0.2158F, 1e-3F);
}

TEST(Color, WeightsGoFromWhiteOverBlueToBlack) {
  EXPECT_GT(weight_color(0).r, 0.8F);
  const Color half = weight_color(0.5F);
  EXPECT_GT(half.b, 4 * half.r);
  EXPECT_LT(weight_color(1).b, 0.02F);
  EXPECT_EQ(weight_color(7), weight_color(1));
}

}  // namespace
}  // namespace penpose::render
