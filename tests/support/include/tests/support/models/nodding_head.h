#pragma once

#include <algorithm>
#include <cmath>

#include "core/geometry/space.h"

namespace penpose::tests {

/// Turned by an angle from axis i towards axis j.
inline geometry::ModelPoint turned(geometry::ModelPoint v, double angle, int i, int j) {
  const double x = v[i];
  const double y = v[j];
  v[i] = std::cos(angle) * x - std::sin(angle) * y;
  v[j] = std::sin(angle) * x + std::cos(angle) * y;
  return v;
}

/// A head that rolls, nods and looks about by up to 20 degrees and sways.
inline geometry::ModelPoint nodding(std::size_t frame, geometry::ModelPoint p) {
  const double t = static_cast<double>(frame) / 30.0;
  const double in = std::min(1.0, t);
  const geometry::ModelPoint neck(0, -8, 0);
  p = turned(p - neck, in * 0.35 * std::sin(1.1 * t), 0, 1);
  p = turned(p, in * 0.25 * std::sin(0.7 * t), 1, 2);
  p = turned(p, in * 0.3 * std::sin(0.9 * t), 2, 0);
  return p + neck + geometry::ModelVector(2 * std::sin(0.5 * t), std::sin(0.8 * t), 0) * in;
}

}  // namespace penpose::tests
