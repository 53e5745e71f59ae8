#include "core/base/sine_cosine.h"

#include <cmath>
#include <cstddef>

#include "core/base/math.h"

namespace penpose::base {
namespace {

/// An eighth of the angle is at most pi/4, where short Taylor series hold; three doublings of (sin, 1 - cos) bring the
/// angle back: sin 2x = 2 sin x cos x, 1 - cos 2x = 2 sin^2 x.
void short_angles(const double* angles, double* sines, double* cosines, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const double x = angles[i] * 0.125;
    const double t = x * x;
    double s = 1.0 / 6227020800.0 - t * (1.0 / 1307674368000.0);
    s = 1.0 / 39916800.0 - t * s;
    s = 1.0 / 362880.0 - t * s;
    s = 1.0 / 5040.0 - t * s;
    s = 1.0 / 120.0 - t * s;
    s = 1.0 / 6.0 - t * s;
    s = x - x * t * s;
    double v = 1.0 / 87178291200.0 - t * (1.0 / 20922789888000.0);
    v = 1.0 / 479001600.0 - t * v;
    v = 1.0 / 3628800.0 - t * v;
    v = 1.0 / 40320.0 - t * v;
    v = 1.0 / 720.0 - t * v;
    v = 1.0 / 24.0 - t * v;
    v = 0.5 - t * v;
    v = t * v;
    for (int doubling = 0; doubling < 3; ++doubling) {
      const double doubled = 2.0 * s * (1.0 - v);
      v = 2.0 * s * s;
      s = doubled;
    }
    sines[i] = s;
    cosines[i] = 1.0 - v;
  }
}

}  // namespace

void sine_cosine(std::span<const double> angles, std::span<double> sines, std::span<double> cosines) {
  bool all_short = true;
  for (const double angle : angles) all_short = all_short && std::abs(angle) <= 2.0 * k_pi;
  if (all_short) {
    short_angles(angles.data(), sines.data(), cosines.data(), angles.size());
    return;
  }
  for (std::size_t i = 0; i < angles.size(); ++i) {
    sines[i] = sin(angles[i]);
    cosines[i] = cos(angles[i]);
  }
}

}  // namespace penpose::base
