#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/geometry/space.h"

namespace penpose::portrait {

using geometry::PxPoint;

/// A smooth map of the picture that takes points near to where they are drawn: a thin-plate spline (Bookstein, IEEE
/// PAMI 11, 1989), with the deviation at a point weighed against its bending. What a control moves goes along with it.
class SheetWarp {
 public:
  /// `points` and `there`: as many, at least 3 that are not on one line; else the map is the identity. px of the face.
  SheetWarp(std::span<const PxPoint> points, std::span<const PxPoint> there);

  /// By how much a point is moved.
  [[nodiscard]] PxPoint offset(const PxPoint& p) const;
  /// How a small step at a point is mapped: d x' / d x, d x' / d y, d y' / d x, d y' / d y.
  [[nodiscard]] std::array<double, 4> derivative(const PxPoint& p) const;

 private:
  std::vector<PxPoint> points_;
  std::vector<PxPoint> weights_;
  std::array<PxPoint, 3> affine_{};
};

}  // namespace penpose::portrait
