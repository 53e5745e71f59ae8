#pragma once

#include <span>
#include <vector>

#include "core/geometry/space.h"

namespace penpose::articulation {

using geometry::ModelPoint;
using geometry::ModelVector;

/// Weights of a curve's segments for a point in space, and the place on each: nearer segments weigh more, over a width
/// that grows with the point's distance. On the curve itself only the place there counts; far away the whole curve
/// does. Smooth in space, where the closest point alone would jump from one limb of a curve to another.
class Attachment {
 public:
  /// Precondition: at least two points.
  explicit Attachment(std::span<const ModelPoint> curve);

  void attach(const ModelPoint& point);

  [[nodiscard]] double distance() const { return distance_; }  ///< to the curve
  /// The place on the curve, in segments from its start: the weighted mean of all places.
  [[nodiscard]] double place() const;
  /// The weighted mean of `values`, one for each point of the curve.
  [[nodiscard]] ModelVector mean_of_points(std::span<const ModelVector> values) const;
  /// The weighted mean of values, one for each segment of the curve.
  [[nodiscard]] ModelVector mean_of_segments(std::span<const ModelVector> values) const;

 private:
  struct Segment {
    ModelPoint from{0};
    ModelVector along{0};
    double inverse_square = 0;  ///< 1/length^2; 0 for one without length
    double length = 0;
  };
  std::vector<Segment> segments_;
  double step_ = 1;  ///< mean length of the segments
  std::vector<double> fractions_, squares_, shares_;
  double distance_ = 0;
};

}  // namespace penpose::articulation
