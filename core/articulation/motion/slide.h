#pragma once

#include <span>
#include <vector>

#include "core/articulation/sketch.h"

namespace penpose::articulation {

/// The motion of a curve over a ball: every point turns about one axis through the centre, square to where the curve
/// lies and to where it goes, so that what is carried along keeps its width along that axis whatever its weight; what
/// that leaves to the target is a tilt on a great circle.
class Slide {
 public:
  /// Precondition: equally many points, at least two, all finite.
  Slide(const ModelPoint& center, std::span<const ModelPoint> reference, std::span<const ModelPoint> target);

  [[nodiscard]] const ModelPoint& center() const { return center_; }
  /// Along which what is carried keeps its width: of length 1, or 0 where the ways have no axis in common.
  [[nodiscard]] const ModelVector& axis() const { return axis_; }
  /// Of each point at amount 1: axis times angle about the common axis, and the turn after it.
  [[nodiscard]] std::span<const ModelVector> turns() const { return turns_; }
  [[nodiscard]] std::span<const ModelVector> tilts() const { return tilts_; }

 private:
  ModelPoint center_;
  ModelVector axis_{0};
  std::vector<ModelVector> turns_;
  std::vector<ModelVector> tilts_;
};

/// v turned by axis times angle.
[[nodiscard]] ModelVector turned_by(const ModelVector& turn, const ModelVector& v);

}  // namespace penpose::articulation
