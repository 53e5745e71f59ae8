#pragma once

#include <cmath>
#include <vector>

#include "core/geometry/space.h"
#include "tests/support/random.h"

namespace penpose::tests {

/// A line with a smooth tremor of 2.5 px, whose waves turn by these angles (radians) from one point to the next.
inline std::vector<geometry::PxPoint> with_tremor(std::vector<geometry::PxPoint> line, Random& random, double slowest,
                                                  double fastest) {
  const double a = random(0, 6), b = random(0, 6), c = random(slowest, fastest), d = random(slowest, fastest);
  for (std::size_t i = 0; i < line.size(); ++i) {
    const double t = static_cast<double>(i);
    line[i] = line[i] + geometry::PxPoint{2.5 * std::sin(a + c * t), 2.5 * std::sin(b + d * t)};
  }
  return line;
}

}  // namespace penpose::tests
