#pragma once

#include <memory>

#include "core/geometry/camera.h"
#include "ui/render/picture/image.h"

namespace penpose::render {

/// A picture behind the model, or before it: its corners in px of the view, y down, and how much of it shows.
struct Behind {
  std::shared_ptr<const Image> image;  ///< null: none
  geometry::PxPoint from;
  geometry::PxPoint to;
  float opacity = 1;
  bool front = false;  ///< before the model
  friend bool operator==(const Behind&, const Behind&) = default;
};

}  // namespace penpose::render
