#include "ui/app/widgets/internal/picture_sheet.h"

#include <algorithm>
#include <bit>

namespace penpose::app {
namespace {

/// No texture of letters is narrower (ImFontAtlas::Build).
constexpr int k_narrowest_px = 512;

}  // namespace

void PictureSheet::reserve(ImFontAtlas& atlas) {
  const int side = px_ * across_;
  rect_ = atlas.AddCustomRectRegular(side, side);
  // Few letters alone make a texture that is narrower, in which there is no room.
  const auto wide_enough = static_cast<int>(std::bit_ceil(static_cast<unsigned>(side + atlas.TexGlyphPadding)));
  if (wide_enough > k_narrowest_px) atlas.TexDesiredWidth = std::max(atlas.TexDesiredWidth, wide_enough);
}

bool PictureSheet::ready() const { return reserved() && ImGui::GetIO().Fonts->TexPixelsRGBA32 != nullptr; }

std::pair<int, int> PictureSheet::corner(std::size_t place) const {
  const ImFontAtlasCustomRect& rect = *ImGui::GetIO().Fonts->GetCustomRectByIndex(rect_);
  const int at = static_cast<int>(place);
  return {rect.X + px_ * (at % across_), rect.Y + px_ * (at / across_)};
}

std::pair<ImVec2, ImVec2> PictureSheet::corners(std::size_t place) const {
  const ImVec2 share = ImGui::GetIO().Fonts->TexUvScale;
  const auto [x, y] = corner(place);
  const auto at = [&](int across, int down) {
    return ImVec2{static_cast<float>(across) * share.x, static_cast<float>(down) * share.y};
  };
  return {at(x, y), at(x + px_, y + px_)};
}

void PictureSheet::draw(std::size_t place, std::span<const std::uint8_t> pixels) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  const auto [left, top] = corner(place);
  const std::uint8_t* px = pixels.data();
  for (int y = 0; y < px_; ++y) {
    for (int x = 0; x < px_; ++x, px += 4)
      atlas.TexPixelsRGBA32[(top + y) * atlas.TexWidth + left + x] = IM_COL32(px[0], px[1], px[2], px[3]);
  }
}

}  // namespace penpose::app
