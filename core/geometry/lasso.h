#pragma once

#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/space.h"

namespace penpose::geometry {

/// A region of the viewport that somebody drew around. The curve is closed by joining its ends; what lies inside
/// follows the even-odd rule, so that a curve that crosses itself has a clear inside.
class Lasso {
 public:
  /// Errors: fewer than three distinct points, a coordinate that is not finite or beyond a million px.
  static base::Result<Lasso> make(std::span<const PxPoint> curve);

  [[nodiscard]] bool contains(PxPoint point) const;
  /// Distance in px from a point to the closed curve itself, inside or outside.
  [[nodiscard]] double distance(PxPoint point) const;

 private:
  struct Edge {
    PxPoint from;
    PxPoint to;
  };
  /// The box around a run of edges, which lets most of them be skipped.
  struct Run {
    std::size_t begin = 0;
    std::size_t end = 0;
    PxPoint minimum;
    PxPoint maximum;
  };

  std::vector<Edge> edges_;
  std::vector<Run> runs_;
};

/// The largest magnitude of a px coordinate that a curve may have.
inline constexpr double k_largest_px = 1e6;

}  // namespace penpose::geometry
