#pragma once

#include <vector>

#include "core/base/result.h"

namespace penpose::decode {

/// A user's pressure curve: straight lines between points of pressure as pressed and pressure as meant, both 0..1.
class PressureCurve {
 public:
  struct Point {
    double pressed = 0;
    double meant = 0;
  };

  /// Leaves pressure as it is.
  PressureCurve() = default;

  /// At least two points from pressed 0 to pressed 1, `pressed` rising, `meant` never falling, all within 0..1. The
  /// error names the number of the point that breaks this.
  [[nodiscard]] static base::Result<PressureCurve> make(std::vector<Point> points);

  /// `pressed` outside of 0..1 counts as the nearer end.
  [[nodiscard]] double operator()(double pressed) const;

 private:
  std::vector<Point> points_;  ///< empty: straight from 0 to 1
};

}  // namespace penpose::decode
