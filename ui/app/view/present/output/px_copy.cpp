#include "ui/app/view/present/output/px_copy.h"

#include <SDL2/SDL.h>
#include <algorithm>
#include <cstddef>

namespace penpose::app {

render::PxRect copy_px(const render::Image& picture, const render::PxRect& part, const PxMemory& to) {
  const render::PxRect both{0, 0, std::min(picture.width, to.size.width), std::min(picture.height, to.size.height)};
  const render::PxRect inside = render::shared_part(part, both);
  if (inside.empty()) return inside;
  std::uint8_t* const begin = to.px + static_cast<std::ptrdiff_t>(inside.top) * to.row_bytes +
                              static_cast<std::ptrdiff_t>(inside.left) * SDL_BYTESPERPIXEL(to.format);
  SDL_ConvertPixels(inside.right - inside.left, inside.bottom - inside.top, SDL_PIXELFORMAT_RGBA32,
                    picture.at(inside.left, inside.top), picture.width * 4, to.format, begin, to.row_bytes);
  return inside;
}

}  // namespace penpose::app
