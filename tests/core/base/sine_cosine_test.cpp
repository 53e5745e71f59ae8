#include "core/base/sine_cosine.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace penpose::base {
namespace {

TEST(SineCosine, AgreesWithALongDoubleReference) {
  std::vector<double> angles;
  for (int i = -20000; i <= 20000; ++i) angles.push_back(i * (6.283185307 / 20000));
  std::vector<double> sines(angles.size());
  std::vector<double> cosines(angles.size());
  sine_cosine(angles, sines, cosines);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const auto angle = static_cast<long double>(angles[i]);
    EXPECT_NEAR(sines[i], static_cast<double>(std::sin(angle)), 2e-15) << angles[i];
    EXPECT_NEAR(cosines[i], static_cast<double>(std::cos(angle)), 2e-15) << angles[i];
  }
}

TEST(SineCosine, IsExactAtZeroAndGoesOnBeyondATurn) {
  const std::vector<double> angles = {0.0, 100.0, -31.0};
  std::vector<double> sines(3);
  std::vector<double> cosines(3);
  sine_cosine({angles.data(), 1}, {sines.data(), 1}, {cosines.data(), 1});
  EXPECT_EQ(sines[0], 0.0);
  EXPECT_EQ(cosines[0], 1.0);
  sine_cosine(angles, sines, cosines);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(sines[i], std::sin(angles[i]), 1e-14);
    EXPECT_NEAR(cosines[i], std::cos(angles[i]), 1e-14);
  }
}

TEST(SineCosine, GivesEachAngleTheSameBitsWhateverItsNeighbours) {
  std::vector<double> angles;
  for (int i = 0; i < 13; ++i) angles.push_back(0.37 * i - 2);
  std::vector<double> sines(13);
  std::vector<double> cosines(13);
  sine_cosine(angles, sines, cosines);
  for (std::size_t i = 0; i < 13; ++i) {
    double sine = 0;
    double cosine = 0;
    sine_cosine({&angles[i], 1}, {&sine, 1}, {&cosine, 1});
    EXPECT_EQ(sine, sines[i]);
    EXPECT_EQ(cosine, cosines[i]);
  }
}

}  // namespace
}  // namespace penpose::base
