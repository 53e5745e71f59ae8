#pragma once

#include <span>
#include <vector>

#include "core/geometry/space.h"

namespace penpose::articulation {

using geometry::ModelPoint;
using geometry::ModelVector;

/// How much each segment of a curve has to say about a point in space, and where on it: the nearer the segment the
/// more, over a width that grows with the point's distance. On the curve itself only the place there counts; far away
/// the whole curve does. Smooth through space, where the closest point alone jumps from one limb of a curve to another.
class Attachment {
 public:
  /// Precondition: at least two points.
  explicit Attachment(std::span<const ModelPoint> curve);

  void attach(const ModelPoint& point);

  [[nodiscard]] double distance() const { return distance_; }  ///< to the curve
  /// The place on the curve, in segments from its start: the mean of all places.
  [[nodiscard]] double place() const;
  /// The mean of what is given at the curve's points, `values`, at all places.
  [[nodiscard]] ModelVector mean_of_points(std::span<const ModelVector> values) const;
  /// The mean of what is given for the curve's segments.
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
