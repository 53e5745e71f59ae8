#pragma once

#include <cstdint>

#include "core/geometry/camera.h"
#include "ui/render/cpu/triangles/triangle_raster.h"
#include "ui/render/picture/image.h"

namespace penpose::app {

/// Memory that a screen or a window shows.
struct PxMemory {
  std::uint8_t* px = nullptr;
  int row_bytes = 0;
  std::uint32_t format = 0;  ///< SDL_PixelFormatEnum
  geometry::Viewport size;
};

/// Copies a part of a picture to the same place there, in the format there. The part that was copied: what is inside of
/// both.
render::PxRect copy_px(const render::Image& picture, const render::PxRect& part, const PxMemory& to);

}  // namespace penpose::app
