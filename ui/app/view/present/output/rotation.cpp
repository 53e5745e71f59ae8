#include "ui/app/view/present/output/rotation.h"

#include <cstddef>
#include <cstring>
#include <utility>

namespace penpose::app {

std::optional<Rotation> rotation_of(int degrees) {
  switch (degrees) {
    case 0:
      return Rotation::none;
    case 90:
      return Rotation::quarter;
    case 180:
      return Rotation::half;
    case 270:
      return Rotation::three_quarters;
    default:
      return std::nullopt;
  }
}

geometry::Viewport turned_size(geometry::Viewport size, Rotation rotation) {
  const bool on_side = rotation == Rotation::quarter || rotation == Rotation::three_quarters;
  return on_side ? geometry::Viewport{size.height, size.width} : size;
}

geometry::PxPoint on_picture(geometry::PxPoint on_panel, geometry::Viewport panel, Rotation rotation) {
  const double width = panel.width;
  const double height = panel.height;
  switch (rotation) {
    case Rotation::quarter:
      return {on_panel.y, width - on_panel.x};
    case Rotation::half:
      return {width - on_panel.x, height - on_panel.y};
    case Rotation::three_quarters:
      return {height - on_panel.y, on_panel.x};
    case Rotation::none:
      break;
  }
  return on_panel;
}

render::PxRect on_panel(const render::PxRect& part, geometry::Viewport picture, Rotation rotation) {
  const int width = picture.width;
  const int height = picture.height;
  switch (rotation) {
    case Rotation::quarter:
      return {height - part.bottom, part.left, height - part.top, part.right};
    case Rotation::half:
      return {width - part.right, height - part.bottom, width - part.left, height - part.top};
    case Rotation::three_quarters:
      return {part.top, width - part.right, part.bottom, width - part.left};
    case Rotation::none:
      break;
  }
  return part;
}

void turn(const render::Image& picture, const std::vector<render::PxRect>& parts, Rotation rotation,
          render::Image& panel) {
  const geometry::Viewport size = turned_size({picture.width, picture.height}, rotation);
  panel.width = size.width;
  panel.height = size.height;
  panel.pixels.resize(picture.pixels.size());
  for (const render::PxRect& part : parts) {
    for (int y = part.top; y < part.bottom; ++y) {
      const render::PxRect first =
          on_panel({part.left, y, part.left + 1, y + 1}, {picture.width, picture.height}, rotation);
      const std::ptrdiff_t row = std::ptrdiff_t{4} * size.width;
      const std::ptrdiff_t step = rotation == Rotation::none      ? 4
                                  : rotation == Rotation::quarter ? row
                                  : rotation == Rotation::half    ? -4
                                                                  : -row;
      std::ptrdiff_t to = first.top * row + std::ptrdiff_t{4} * first.left;
      const std::uint8_t* from = picture.at(part.left, y);
      for (int x = part.left; x < part.right; ++x, from += 4, to += step)
        std::memcpy(&panel.pixels[static_cast<std::size_t>(to)], from, 4);
    }
  }
}

}  // namespace penpose::app
