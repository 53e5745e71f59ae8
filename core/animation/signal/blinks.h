#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace penpose::animation {

/// One blink: its frames, its shape over time, and the depth for each eye, as a share of the usual opening.
struct Blink {
  std::size_t first = 0, peak = 0, last = 0;  ///< the eye is open at first and last
  std::vector<double> shape;                  ///< one a frame, first to last: 0 open, 1 deepest, as seen
  std::vector<double> lids;                   ///< the same for the lids of a model (closed_in_a_frame)
  std::vector<double> depth;                  ///< one an eye
  double sure = 1;                            ///< 0 to 1: certainty that it is one
};

/// Positions of an eye's lid points across the eye, one list a point, one number a frame, in any unit.
using LidPoints = std::vector<std::vector<double>>;

/// The blinks of a clip, ascending. `seen`: each eye's opening as a share of its usual one; `points`: one an eye, or
/// none; otherwise as find_eye_motion.
///
/// Tremor must not decide: a dip that barely exceeds it counts partly, and a blink has the shape of ramps (ramps.h)
/// with corners between frames; their duration is estimated from all blinks of the clip.
[[nodiscard]] std::vector<Blink> find_blinks(const std::vector<std::vector<double>>& seen,
                                             std::span<const LidPoints> points, std::span<const double> confidence,
                                             double frames_per_s, std::span<const double> column);

}  // namespace penpose::animation
