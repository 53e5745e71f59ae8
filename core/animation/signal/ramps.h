#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace penpose::animation {

/// The course of a blink: down in a ramp, a floor, up in a ramp. Times in frames, not whole ones.
struct Ramps {
  double start = 0;  ///< of the way down
  double down = 1;   ///< how long it takes
  double floor = 0;
  double up = 1;
  double height = 0;

  /// 0 to 1.
  [[nodiscard]] double at(double frame) const;
};

/// How long the blinks of a person usually take, and how far they differ in that: the standard deviations of a normal
/// law.
struct UsualRamps {
  double down = 0, floor = 0, up = 0;
  double down_differs = 0, floor_differs = 0, up_differs = 0;
};

/// The ramps that leave the least squares of the dips: all corners on half frames (or on wider steps where there are
/// many dips), and from the best of them on by a search of ever smaller steps, so that where the corners come to lie
/// changes as little as the dips do. `dips`: around a peak, which is number `peak` of them and neither first nor last.
/// `deviation`: of their tremor, above 0.
[[nodiscard]] Ramps fit_ramps(std::span<const double> dips, std::size_t peak, double deviation,
                              const std::optional<UsualRamps>& usual = std::nullopt);

/// Moves ramps without a floor, by less than half a frame, so that their deepest point comes to lie in a frame: an eye
/// that closes is seen closed. Those that lie in the middle between two frames stay, and nothing jumps from one to the
/// next.
[[nodiscard]] Ramps closed_in_a_frame(Ramps ramps);

/// What the ramps of a clip have in common, each known as well as the tremor lets it be; nothing where there are fewer
/// than three.
[[nodiscard]] std::optional<UsualRamps> usual_ramps(std::span<const Ramps> all, double deviation);

}  // namespace penpose::animation
