#pragma once

#include <cstdint>

namespace penpose::base {

/// An angle less the multiple of pi/2 that is nearest to it: x = quadrant * pi/2 + high + low, the quadrant modulo 4.
struct ReducedAngle {
  double high = 0;
  double low = 0;
  std::int64_t quadrant = 0;
};

/// The reduction of Payne and Hanek (ACM SIGNUM Newsletter 18, 1983) for angles so large that multiples of pi/2 cannot
/// be taken away in doubles. Precondition: x is finite and 2^20 or more in magnitude.
[[nodiscard]] ReducedAngle reduce_large_angle(double x);

}  // namespace penpose::base
