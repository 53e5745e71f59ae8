#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace penpose::animation {

/// The shape of a blink: a ramp down, a floor, a ramp up. Times are in frames and need not be whole.
struct Ramps {
  double start = 0;  ///< of the way down
  double down = 1;   ///< its duration
  double floor = 0;
  double up = 1;
  double height = 0;

  /// 0 to 1.
  [[nodiscard]] double at(double frame) const;
};

/// The usual duration of a person's blinks, and its standard deviation.
struct UsualRamps {
  double down = 0, floor = 0, up = 0;
  double down_differs = 0, floor_differs = 0, up_differs = 0;
};

/// The least-squares ramps of the dips: tries all corners on half frames (or on wider steps where there are many dips),
/// then refines the best in ever smaller steps, so that the corners change as little as the dips do. `dips`: around a
/// peak, which is number `peak` of them and neither first nor last. `deviation`: of their tremor, above 0.
[[nodiscard]] Ramps fit_ramps(std::span<const double> dips, std::size_t peak, double deviation,
                              const std::optional<UsualRamps>& usual = std::nullopt);

/// Moves ramps without a floor by less than half a frame, so that their deepest point falls on a frame: an eye that
/// closes is seen closed. Those in the middle between two frames stay, so that nothing jumps from one to the next.
[[nodiscard]] Ramps closed_in_a_frame(Ramps ramps);

/// The common durations of a clip's ramps, each weighted by its certainty under the tremor; nothing for fewer than
/// three.
[[nodiscard]] std::optional<UsualRamps> usual_ramps(std::span<const Ramps> all, double deviation);

}  // namespace penpose::animation
