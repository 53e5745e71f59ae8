#pragma once

#include <vector>

#include "core/base/result.h"

namespace penpose::decode {

/// A user's pressure curve: piecewise linear from pressed to meant pressure, both 0..1.
class PressureCurve {
 public:
  struct Point {
    double pressed = 0;
    double meant = 0;
  };

  /// The identity.
  PressureCurve() = default;

  /// At least two points from pressed 0 to pressed 1, `pressed` rising, `meant` never falling, all within 0..1. The
  /// error names the number of the first bad point.
  [[nodiscard]] static base::Result<PressureCurve> make(std::vector<Point> points);

  /// `pressed` is clamped to 0..1.
  [[nodiscard]] double operator()(double pressed) const;

 private:
  std::vector<Point> points_;  ///< empty: the identity
};

}  // namespace penpose::decode
