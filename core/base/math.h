#pragma once

namespace penpose::base {

// The platform's libm gives other last bits on other machines; these functions give the same bits everywhere, because
// they are made of IEEE additions, multiplications, divisions and square roots in a written order. Errors are at most 2
// units in the last place in the ranges stated (measured by the tests against long double references).

inline constexpr double k_pi = 3.14159265358979323846;

[[nodiscard]] constexpr double radians(double degrees) { return degrees * (k_pi / 180.0); }
[[nodiscard]] constexpr double degrees(double radians) { return radians * (180.0 / k_pi); }

/// Sine and cosine of an angle in radians of any size; NaN for infinities and NaN.
[[nodiscard]] double sin(double x);
[[nodiscard]] double cos(double x);
[[nodiscard]] double tan(double x);
/// Arc tangent of y/x in the right quadrant, -pi..pi; atan2(0, 0) is 0.
[[nodiscard]] double atan2(double y, double x);
/// Arc cosine, 0..pi; the argument is clamped to -1..1, so that rounding cannot make a NaN of a unit dot product.
[[nodiscard]] double acos(double x);
/// e to the x: 0 below -745.2, infinity above 709.79.
[[nodiscard]] double exp(double x);
/// Natural logarithm: -infinity at 0, NaN below.
[[nodiscard]] double log(double x);
/// x to the y for x >= 0 (NaN for negative x); pow(x, 0) is 1. Relative error up to 1e-13 for results within
/// 1e-100..1e100.
[[nodiscard]] double pow(double x, double y);

}  // namespace penpose::base
