#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/geometry/space.h"

namespace penpose::judges {

/// A kind of gesture: how lines are bent in the picture, and which muscles (parts.h) an artist means by it.
struct GestureKind {
  /// Where a point of a line goes. `s`: 0 to 1 along the line; `t`: -1 to 1 across the mouth; `half`: half of the
  /// mouth's width, px.
  using Bend = std::function<geometry::PxPoint(geometry::PxPoint p, double s, double t, double half)>;
  struct Line {
    std::string name;
    Bend bend;
    std::string towards;  ///< else: a line that it goes to, by `share` of the way
    double share = 0;
  };
  std::string name;
  std::vector<Line> lines;
  std::vector<std::vector<std::string>> needed;  ///< of each group one
  std::vector<std::string> accepted;
};

[[nodiscard]] std::span<const GestureKind> gesture_kinds();

}  // namespace penpose::judges
