#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace penpose::animation {

/// One blink: its frames, its course, and how deep each eye's points go, as a share of the usual opening.
struct Blink {
  std::size_t first = 0, peak = 0, last = 0;  ///< the eye is open at first and last
  std::vector<double> shape;                  ///< one a frame, first to last: 0 open, 1 at the deepest, as seen
  std::vector<double> lids;                   ///< the same, as the lids of a model go (closed_in_a_frame)
  std::vector<double> depth;                  ///< one an eye
  double sure = 1;                            ///< 0 to 1: how far it is one
};

/// Where the points of an eye's lids are across the eye, one list a point, one number a frame, in any unit.
using LidPoints = std::vector<std::vector<double>>;

/// The blinks of a clip, ascending. `seen`: each eye's opening as a share of its usual one; `points`: one an eye, or
/// none; otherwise as find_eye_motion.
///
/// Tremor must not decide: a dip that stands out of it barely is a blink in part, and a blink's course is that of ramps
/// (ramps.h) of which the corners lie between frames; how long they take, all blinks of the clip tell.
[[nodiscard]] std::vector<Blink> find_blinks(const std::vector<std::vector<double>>& seen,
                                             std::span<const LidPoints> points, std::span<const double> confidence,
                                             double frames_per_s, std::span<const double> column);

}  // namespace penpose::animation
