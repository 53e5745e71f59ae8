#include "core/base/math.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/base/large_angle.h"

namespace penpose::base {
namespace {

constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();
constexpr double k_infinity = std::numeric_limits<double>::infinity();

// pi/2 in three pieces of 33 bits and less (Cody and Waite 1980): k * piece is exact for |k| < 2^20.
constexpr double k_half_pi_1 = 0x1.921fb544p0;
constexpr double k_half_pi_2 = 0x1.0b4611a6p-34;
constexpr double k_half_pi_3 = 0x1.3198a2e037073p-69;
constexpr double k_two_over_pi = 0.63661977236758134308;
constexpr double k_rounder = 0x1.8p52;  // adding and subtracting it rounds to the nearest integer

// ln 2 in two pieces, the first of 33 bits.
constexpr double k_ln2_high = 0x1.62e42feep-1;
constexpr double k_ln2_low = 0x1.a39ef35793c76p-33;
constexpr double k_log2_e = 1.44269504088896340736;

/// sum of coefficients[i] * t^i, by Horner's rule.
template <std::size_t N>
double polynomial(const std::array<double, N>& coefficients, double t) {
  double sum = coefficients[N - 1];
  for (std::size_t i = N - 1; i-- > 0;) sum = sum * t + coefficients[i];
  return sum;
}

// Taylor series about 0; on |r| <= pi/4 the first omitted term is below 1e-17 of the result.
constexpr std::array<double, 8> k_sin_series = {-1.0 / 6,
                                                1.0 / 120,
                                                -1.0 / 5040,
                                                1.0 / 362880,
                                                -1.0 / 39916800,
                                                1.0 / 6227020800.0,
                                                -1.0 / 1307674368000.0,
                                                1.0 / 355687428096000.0};
constexpr std::array<double, 8> k_cos_series = {1.0 / 24,
                                                -1.0 / 720,
                                                1.0 / 40320,
                                                -1.0 / 3628800,
                                                1.0 / 479001600.0,
                                                -1.0 / 87178291200.0,
                                                1.0 / 20922789888000.0,
                                                -1.0 / 6402373705728000.0};

// From here on k * piece is not exact any more.
constexpr double k_large_angle = 0x1p20;

ReducedAngle reduce(double x) {
  if (std::abs(x) >= k_large_angle) return reduce_large_angle(x);
  const double k = (x * k_two_over_pi + k_rounder) - k_rounder;
  const double first = x - k * k_half_pi_1;
  const double second = k * k_half_pi_2;
  const double third = k * k_half_pi_3;
  const double partial = first - second;
  const double tail = ((first - partial) - second) - third;
  const double high = partial + tail;
  return {high, (partial - high) + tail, static_cast<std::int64_t>(k)};
}

double sin_kernel(double r, double low) {
  const double t = r * r;
  return r + (r * t * polynomial(k_sin_series, t) + low * (1.0 - 0.5 * t));
}

double cos_kernel(double r, double low) {
  const double t = r * r;
  const double half = 0.5 * t;
  const double head = 1.0 - half;
  return head + (((1.0 - head) - half) + (t * t * polynomial(k_cos_series, t) - r * low));
}

double sin_of_quadrant(const ReducedAngle& r, std::int64_t quadrant) {
  const double magnitude = (quadrant & 1) != 0 ? cos_kernel(r.high, r.low) : sin_kernel(r.high, r.low);
  return (quadrant & 2) != 0 ? -magnitude : magnitude;
}

// atan(x) = atan(c) + atan((x - c) / (1 + x c)); with c = i/8 the reduced argument is at most 1/16 and the series is
// short.
constexpr std::array<double, 9> k_atan_of_eighths = {0.0,
                                                     0.12435499454676143503,
                                                     0.24497866312686415417,
                                                     0.35877067027057222040,
                                                     0.46364760900080611621,
                                                     0.55859931534356243597,
                                                     0.64350110879328438680,
                                                     0.71882999962162450542,
                                                     0.78539816339744830962};
constexpr std::array<double, 8> k_atan_series = {-1.0 / 3,  1.0 / 5,  -1.0 / 7,  1.0 / 9,
                                                 -1.0 / 11, 1.0 / 13, -1.0 / 15, 1.0 / 17};

/// atan of 0..1.
double atan_unit(double x) {
  const double eighths = (x * 8.0 + k_rounder) - k_rounder;
  const double c = eighths * 0.125;
  const double r = (x - c) / (1.0 + x * c);
  const double t = r * r;
  return k_atan_of_eighths[static_cast<std::size_t>(eighths)] + (r + r * t * polynomial(k_atan_series, t));
}

}  // namespace

double sin(double x) {
  if (!std::isfinite(x)) return k_nan;
  const ReducedAngle r = reduce(x);
  return sin_of_quadrant(r, r.quadrant);
}

double cos(double x) {
  if (!std::isfinite(x)) return k_nan;
  const ReducedAngle r = reduce(x);
  return sin_of_quadrant(r, r.quadrant + 1);
}

double tan(double x) { return sin(x) / cos(x); }

double atan2(double y, double x) {
  if (x != x || y != y) return k_nan;
  double ay = std::abs(y);
  double ax = std::abs(x);
  if (ay == 0.0 && ax == 0.0) return 0.0;
  if (std::isinf(ay) && std::isinf(ax)) ay = ax = 1.0;
  double angle = ay <= ax ? atan_unit(ay / ax) : k_pi / 2 - atan_unit(ax / ay);
  if (x < 0.0) angle = k_pi - angle;
  return y < 0.0 ? -angle : angle;
}

double acos(double x) {
  if (x != x) return k_nan;
  x = std::clamp(x, -1.0, 1.0);
  // 1 - x^2 as a product keeps its precision near the ends.
  return atan2(std::sqrt((1.0 - x) * (1.0 + x)), x);
}

double exp(double x) {
  if (x != x) return k_nan;
  if (x > 709.79) return k_infinity;
  if (x < -745.2) return 0.0;
  const double k = (x * k_log2_e + k_rounder) - k_rounder;
  const double r = (x - k * k_ln2_high) - k * k_ln2_low;
  constexpr std::array<double, 13> k_series = {0.5,
                                               1.0 / 6,
                                               1.0 / 24,
                                               1.0 / 120,
                                               1.0 / 720,
                                               1.0 / 5040,
                                               1.0 / 40320,
                                               1.0 / 362880,
                                               1.0 / 3628800,
                                               1.0 / 39916800,
                                               1.0 / 479001600.0,
                                               1.0 / 6227020800.0,
                                               1.0 / 87178291200.0};
  const double e_r = 1.0 + (r + r * r * polynomial(k_series, r));
  // 2^k in two factors, so that results near the ends of the range are reached without overflow on the way.
  const auto exponent = static_cast<std::int64_t>(k);
  const std::int64_t half = exponent / 2;
  const auto power = [](std::int64_t n) { return std::bit_cast<double>(static_cast<std::uint64_t>(n + 1023) << 52); };
  return e_r * power(half) * power(exponent - half);
}

double log(double x) {
  if (x != x || x < 0.0) return k_nan;
  if (x == 0.0) return -k_infinity;
  if (std::isinf(x)) return k_infinity;
  int exponent = 0;
  double mantissa = std::frexp(x, &exponent);  // exact; 0.5 <= mantissa < 1
  if (mantissa < 0.70710678118654752440) {
    mantissa *= 2.0;
    --exponent;
  }
  // log(m) = 2 atanh((m - 1) / (m + 1)), |s| <= 0.1716.
  const double f = mantissa - 1.0;
  const double s = f / (2.0 + f);
  const double t = s * s;
  constexpr std::array<double, 11> k_series = {2.0 / 3,  2.0 / 5,  2.0 / 7,  2.0 / 9,  2.0 / 11, 2.0 / 13,
                                               2.0 / 15, 2.0 / 17, 2.0 / 19, 2.0 / 21, 2.0 / 23};
  const double tail = s * t * polynomial(k_series, t);
  const double k = exponent;
  return k * k_ln2_high + (2.0 * s + (tail + k * k_ln2_low));
}

double pow(double x, double y) {
  if (y == 0.0) return 1.0;
  if (x != x || y != y || x < 0.0) return k_nan;
  if (x == 0.0) return y > 0.0 ? 0.0 : k_infinity;
  return exp(y * log(x));
}

}  // namespace penpose::base
