#include "core/base/math.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace penpose::base {
namespace {

/// Distance from the long double reference in units of the last place of the double result.
double ulps(double got, long double want) {
  const double spacing =
      std::nextafter(std::abs(static_cast<double>(want)), INFINITY) - std::abs(static_cast<double>(want));
  return static_cast<double>(std::abs(static_cast<long double>(got) - want) / static_cast<long double>(spacing));
}

template <typename Ours, typename Reference>
double worst(double low, double high, Ours ours, Reference reference) {
  std::mt19937_64 random(7);
  double most = 0;
  for (int i = 0; i < 200000; ++i) {
    const double x = low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
    most = std::max(most, ulps(ours(x), reference(static_cast<long double>(x))));
  }
  return most;
}

TEST(Math, StaysWithinTwoUnitsInTheLastPlace) {
  EXPECT_LT(worst(-7, 7, sin, [](long double x) { return std::sin(x); }), 2);
  EXPECT_LT(worst(-7, 7, cos, [](long double x) { return std::cos(x); }), 2);
  EXPECT_LT(worst(-1e5, 1e5, sin, [](long double x) { return std::sin(x); }), 2);
  EXPECT_LT(worst(-700, 700, exp, [](long double x) { return std::exp(x); }), 2);
  EXPECT_LT(worst(1e-3, 50, log, [](long double x) { return std::log(x); }), 2);
  EXPECT_LT(worst(0, 1e300, log, [](long double x) { return std::log(x); }), 2);
  EXPECT_LT(worst(
                -3, 3, [](double x) { return atan2(x, 0.7); },
                [](long double x) { return std::atan2(x, static_cast<long double>(0.7)); }),
            2);
  EXPECT_LT(worst(
                -3, 3, [](double x) { return atan2(0.3, x); },
                [](long double x) { return std::atan2(static_cast<long double>(0.3), x); }),
            2);
  EXPECT_LT(worst(-1, 1, acos, [](long double x) { return std::acos(x); }), 3);
}

/// An angle of any size: all sizes equally often.
double any_angle(std::mt19937_64& random) {
  const int exponent = static_cast<int>(random() % 1000) + 20;
  const double mantissa = 1.0 + static_cast<double>(random() >> 12) * 0x1p-52;
  return (random() & 1) != 0 ? std::ldexp(mantissa, exponent) : -std::ldexp(mantissa, exponent);
}

TEST(Math, LargeAnglesAreAsExactAsSmallOnes) {
  std::mt19937_64 random(11);
  double most = 0;
  for (int i = 0; i < 200000; ++i) {
    const double x = any_angle(random);
    most = std::max(most, ulps(sin(x), std::sin(static_cast<long double>(x))));
    most = std::max(most, ulps(cos(x), std::cos(static_cast<long double>(x))));
  }
  EXPECT_LT(most, 2);
  EXPECT_LT(worst(1e6, 2e6, sin, [](long double x) { return std::sin(x); }), 2) << "where one way ends";
  // The double that lies nearest to a multiple of pi/2 (Kahan), and the largest there is.
  const double hard = 6381956970095103.0 * 0x1p797;
  EXPECT_LT(ulps(cos(hard), std::cos(static_cast<long double>(hard))), 2);
  EXPECT_NEAR(cos(hard), -4.68716592425462761112e-19, 1e-33);
  constexpr double k_largest = std::numeric_limits<double>::max();
  EXPECT_LT(ulps(sin(k_largest), std::sin(static_cast<long double>(k_largest))), 2);
  EXPECT_NEAR(sin(1e18), -0.99296932074040507620955301726, 1e-15);
}

TEST(Math, PowerKeepsThirteenDigits) {
  for (double x = 0.01; x < 20; x *= 1.37) {
    for (double y = -5; y < 5; y += 0.31) {
      EXPECT_NEAR(pow(x, y) / std::pow(x, y), 1.0, 1e-13) << x << " " << y;
    }
  }
  EXPECT_EQ(pow(0.0, 2.2), 0.0);
  EXPECT_EQ(pow(0.0, 0.0), 1.0);
  EXPECT_TRUE(std::isnan(pow(-1.0, 0.5)));
}

TEST(Math, HoldsAtTheEdges) {
  EXPECT_EQ(sin(0.0), 0.0);
  EXPECT_EQ(cos(0.0), 1.0);
  EXPECT_EQ(exp(0.0), 1.0);
  EXPECT_EQ(log(1.0), 0.0);
  EXPECT_EQ(exp(1000.0), INFINITY);
  EXPECT_EQ(exp(-1000.0), 0.0);
  EXPECT_GT(exp(-744.0), 0.0);
  EXPECT_EQ(acos(1.0000000001), 0.0);
  EXPECT_DOUBLE_EQ(acos(-2.0), k_pi);
  EXPECT_TRUE(std::isnan(sin(INFINITY)));
  EXPECT_EQ(atan2(0.0, 0.0), 0.0);
  EXPECT_DOUBLE_EQ(atan2(1.0, 0.0), k_pi / 2);
  EXPECT_DOUBLE_EQ(atan2(0.0, -1.0), k_pi);
  EXPECT_DOUBLE_EQ(atan2(-1.0, -1.0), -3 * k_pi / 4);
}

}  // namespace
}  // namespace penpose::base
