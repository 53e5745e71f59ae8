#include "ui/app/view/present/panel_layer.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <imgui.h>
#include <limits>

namespace penpose::app {
namespace {

constexpr int k_width = 64;
constexpr int k_height = 48;

/// Draws one list of ImGui on a grey picture.
class PanelsOverAPicture : public testing::Test {
 protected:
  PanelsOverAPicture() : picture_{k_width, k_height, {}} {
    picture_.pixels.assign(static_cast<std::size_t>(k_width * k_height * 4), 100);
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().Fonts->AddFontDefault();
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    ImGui::GetIO().DisplaySize = {k_width, k_height};
    ImGui::NewFrame();
  }
  ~PanelsOverAPicture() override { ImGui::DestroyContext(); }
  PanelsOverAPicture(const PanelsOverAPicture&) = delete;
  PanelsOverAPicture& operator=(const PanelsOverAPicture&) = delete;

  [[nodiscard]] static ImDrawList& list() { return *ImGui::GetForegroundDrawList(); }
  void paint() {
    ImGui::Render();
    layer_.lay(*ImGui::GetDrawData(), picture_);
  }
  [[nodiscard]] int red(int x, int y) const { return picture_.at(x, y)[0]; }
  /// The sum of what was drawn in white, in px.
  [[nodiscard]] double drawn() const {
    double sum = 0;
    for (int y = 0; y < k_height; ++y) {
      for (int x = 0; x < k_width; ++x) sum += (red(x, y) - 100) / 155.0;
    }
    return sum;
  }

  PanelLayer layer_;
  render::Image picture_;
};

TEST_F(PanelsOverAPicture, ARectangleHasThePxWhoseMiddlesItCovers) {
  list().AddRectFilled({10, 5}, {20.4F, 15.6F}, IM_COL32_WHITE);
  paint();
  EXPECT_EQ(red(10, 5), 255);
  EXPECT_EQ(red(19, 15), 255);
  EXPECT_EQ(red(20, 10), 100);
  EXPECT_EQ(red(9, 10), 100);
  EXPECT_EQ(red(15, 16), 100);
}

TEST_F(PanelsOverAPicture, WhatIsHalfOpaqueIsLaidOverWhatIsThere) {
  list().AddRectFilled({0, 0}, {40, 40}, IM_COL32(200, 200, 200, 128));
  paint();
  EXPECT_NEAR(red(20, 20), 150, 1);
  EXPECT_EQ(picture_.at(20, 20)[3], 178) << "alpha, too";
}

TEST_F(PanelsOverAPicture, NothingIsDrawnOutsideTheClippingRectangle) {
  list().PushClipRect({8, 8}, {24, 24});
  list().AddRectFilled({0, 0}, {64, 48}, IM_COL32_WHITE);
  list().PopClipRect();
  paint();
  EXPECT_EQ(red(8, 8), 255);
  EXPECT_EQ(red(23, 23), 255);
  for (const auto& [x, y] : {std::pair{7, 10}, std::pair{24, 10}, std::pair{10, 7}, std::pair{10, 24}}) {
    EXPECT_EQ(red(x, y), 100) << x << " " << y;
  }
}

TEST_F(PanelsOverAPicture, RoundThingsHaveTheirAreaAndASoftEdge) {
  list().AddCircleFilled({32, 24}, 15, IM_COL32_WHITE, 64);
  paint();
  EXPECT_NEAR(drawn(), 3.14159 * 15 * 15, 12);
  EXPECT_EQ(red(32, 24), 255);
  int soft = 0;
  for (int x = 0; x < k_width; ++x) soft += red(x, 12) > 100 && red(x, 12) < 255 ? 1 : 0;
  EXPECT_GE(soft, 2);
}

TEST_F(PanelsOverAPicture, ColoursRunBetweenCorners) {
  list().AddRectFilledMultiColor({0, 0}, {64, 48}, IM_COL32(0, 0, 0, 255), IM_COL32(255, 0, 0, 255),
                                 IM_COL32(255, 0, 0, 255), IM_COL32(0, 0, 0, 255));
  paint();
  for (const int x : {4, 20, 40, 60}) EXPECT_NEAR(red(x, 30), 255.0 * (x + 0.5) / 64, 2);
}

TEST_F(PanelsOverAPicture, LettersAreAsInTheirPicture) {
  list().AddText({5, 5}, IM_COL32_WHITE, "E");
  paint();
  const ImFontGlyph& glyph = *ImGui::GetFont()->FindGlyph('E');
  const ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  const int from_x = static_cast<int>(glyph.U0 * static_cast<float>(atlas.TexWidth) + 0.5F);
  const int from_y = static_cast<int>(glyph.V0 * static_cast<float>(atlas.TexHeight) + 0.5F);
  int ink = 0;
  for (int y = 0; y < static_cast<int>(glyph.Y1 - glyph.Y0); ++y) {
    for (int x = 0; x < static_cast<int>(glyph.X1 - glyph.X0); ++x) {
      const unsigned alpha = atlas.TexPixelsRGBA32[(from_y + y) * atlas.TexWidth + from_x + x] >> IM_COL32_A_SHIFT;
      EXPECT_NEAR(red(5 + static_cast<int>(glyph.X0) + x, 5 + static_cast<int>(glyph.Y0) + y), 100 + alpha * 155 / 255,
                  1);
      ink += alpha > 128 ? 1 : 0;
    }
  }
  EXPECT_GT(ink, 8);
}

TEST_F(PanelsOverAPicture, NumbersThatAreNoneDrawNothing) {
  const float none = std::numeric_limits<float>::quiet_NaN();
  list().AddTriangleFilled({none, 3}, {40, none}, {none, 40}, IM_COL32_WHITE);
  paint();
  EXPECT_NEAR(drawn(), 0, 0.01);
}

TEST_F(PanelsOverAPicture, WhatStaysIsNotPaintedAgain) {
  const auto frame = [&](float x) {
    std::fill(picture_.pixels.begin(), picture_.pixels.end(), std::uint8_t{100});
    list().AddRectFilled({4, 4}, {20, 12}, IM_COL32(200, 100, 50, 128));
    list().AddText({x, 36}, IM_COL32_WHITE, "E");
    paint();
    ImGui::NewFrame();
    return layer_.painted();
  };
  EXPECT_EQ(frame(5), 2U) << "two tiles, one above the other";
  const render::Image first = picture_;
  EXPECT_EQ(frame(5), 0U);
  EXPECT_EQ(picture_.pixels, first.pixels);
  EXPECT_EQ(frame(30), 1U) << "the letter has moved in the lower one";
  const render::Image moved = picture_;
  layer_.forget();
  EXPECT_EQ(frame(30), 2U);
  EXPECT_EQ(picture_.pixels, moved.pixels) << "as if all was painted anew";
  EXPECT_EQ(frame(5), 1U);
  EXPECT_EQ(picture_.pixels, first.pixels);
}

TEST_F(PanelsOverAPicture, WhatGoesLeavesThePictureBelow) {
  list().AddRectFilled({0, 0}, {64, 48}, IM_COL32_WHITE);
  paint();
  EXPECT_EQ(red(30, 30), 255);
  ImGui::NewFrame();
  picture_.pixels.assign(picture_.pixels.size(), 100);
  paint();
  EXPECT_EQ(red(30, 30), 100);
}

}  // namespace
}  // namespace penpose::app
