#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace penpose::animation {

/// One blink: its frames, and how deep each eye's points go, as a share of the usual opening.
struct Blink {
  std::size_t first = 0, peak = 0, last = 0;  ///< the eye is open at first and last
  std::vector<double> depth;                  ///< one an eye
  std::vector<double> own_shape;              ///< 0..1, first to last
  std::vector<double> calm_depth;             ///< the same of the steadied opening
  std::vector<bool> calm_shape;               ///< one an eye: the steadied opening keeps its shape
  double backing = 1;                         ///< 0.5 to 1: how far the tracker's own column agrees
};

/// The blinks of a clip, ascending. `seen` and `calm`: each eye's opening as a share of its usual one, before and after
/// it was steadied; otherwise as find_eye_motion.
[[nodiscard]] std::vector<Blink> find_blinks(const std::vector<std::vector<double>>& seen,
                                             const std::vector<std::vector<double>>& calm,
                                             std::span<const double> confidence, double frames_per_s,
                                             std::span<const double> column);

/// The straight line between two frames of a signal.
[[nodiscard]] double between(const std::vector<double>& signal, std::size_t from, std::size_t to, std::size_t at);

}  // namespace penpose::animation
