#pragma once

#include <cstddef>

#include "core/base/result.h"
#include "core/geometry/camera.h"
#include "ui/render/picture/image.h"

namespace penpose::film {

/// Pictures of frames in rows, each with its number beneath.
class ContactSheet {
 public:
  /// Room for `count` pictures of one size in a grid about a third wider than high. Errors: none, or more than a
  /// picture of 16384 px a side and 64 million px has room for.
  static base::Result<ContactSheet> make(std::size_t count, geometry::Viewport cell);

  /// Puts a picture of the size of a cell at a place, counted from 0 in rows. Precondition: below the count.
  void put(std::size_t place, const render::Image& picture, int frame);
  [[nodiscard]] const render::Image& image() const { return image_; }
  [[nodiscard]] std::size_t columns() const { return columns_; }

 private:
  geometry::Viewport cell_;
  std::size_t columns_ = 1;
  int number_px_ = 0;  ///< height of the digits
  render::Image image_;
};

}  // namespace penpose::film
