#pragma once

#include "core/geometry/space.h"

namespace penpose::app {

using geometry::PxPoint;

/// A rectangle of the window in px.
struct Area {
  double left = 0, top = 0, right = 0, bottom = 0;

  [[nodiscard]] double width() const { return right - left; }
  [[nodiscard]] double height() const { return bottom - top; }
  [[nodiscard]] PxPoint middle() const { return {0.5 * (left + right), 0.5 * (top + bottom)}; }
  [[nodiscard]] bool holds(PxPoint p) const { return p.x >= left && p.x < right && p.y >= top && p.y < bottom; }
  friend bool operator==(const Area&, const Area&) = default;
};

}  // namespace penpose::app
