#include "core/base/math.h"

#include <cmath>
#include <gtest/gtest.h>
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
