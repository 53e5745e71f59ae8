#include "ui/app/view/present/output/px_copy.h"

#include <SDL2/SDL.h>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace penpose::app {
namespace {

/// What nearly every screen takes, which SDL converts byte by byte.
void swap_red_and_blue(const std::uint8_t* from, int count, std::uint8_t* to) {
  for (int i = 0; i < count; ++i, from += 4, to += 4) {
    std::uint32_t px = 0;
    std::memcpy(&px, from, 4);
    px = SDL_SwapLE32(px);
    px = (px & 0xff00ff00U) | ((px >> 16U) & 0xffU) | ((px & 0xffU) << 16U);
    // Numbers of 32 bits in the machine's own order.
    std::memcpy(to, &px, 4);
  }
}

}  // namespace

render::PxRect copy_px(const render::Image& picture, const render::PxRect& part, const PxMemory& to) {
  const render::PxRect both{0, 0, std::min(picture.width, to.size.width), std::min(picture.height, to.size.height)};
  const render::PxRect inside = render::shared_part(part, both);
  if (inside.empty()) return inside;
  std::uint8_t* const begin = to.px + static_cast<std::ptrdiff_t>(inside.top) * to.row_bytes +
                              static_cast<std::ptrdiff_t>(inside.left) * SDL_BYTESPERPIXEL(to.format);
  if (to.format == SDL_PIXELFORMAT_ARGB8888 || to.format == SDL_PIXELFORMAT_RGB888) {
    for (int y = inside.top; y < inside.bottom; ++y) {
      swap_red_and_blue(picture.at(inside.left, y), inside.right - inside.left,
                        begin + static_cast<std::ptrdiff_t>(y - inside.top) * to.row_bytes);
    }
    return inside;
  }
  SDL_ConvertPixels(inside.right - inside.left, inside.bottom - inside.top, SDL_PIXELFORMAT_RGBA32,
                    picture.at(inside.left, inside.top), picture.width * 4, to.format, begin, to.row_bytes);
  return inside;
}

}  // namespace penpose::app
