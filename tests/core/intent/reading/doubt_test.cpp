#include "core/intent/reading/doubt.h"

#include <cmath>
#include <gtest/gtest.h>

namespace penpose::intent {
namespace {

TEST(Doubt, LinesThatLieTogetherHaveOneScale) {
  Doubt doubt;
  const std::size_t mouth = doubt.add_group(7);
  const std::size_t brow = doubt.add_group(7);
  doubt.add_curve(mouth);
  doubt.add_curve(brow);
  doubt.add_curve(mouth);
  const std::vector<double> squares{30, 20, 54, 2.5};
  const double together = 7 * std::sqrt(2.0) * std::log(1 + 84.0 / 14.0);
  EXPECT_NEAR(doubt.energy(squares), together + 7 * std::log(1 + 20.0 / 7.0) + 2.5, 1e-12)
      << "what is no curve counts by its squares";
}

TEST(Doubt, WeightsAreTheDerivativesOfTheEnergy) {
  Doubt doubt;
  const std::size_t group = doubt.add_group(7);
  doubt.add_curve(group);
  doubt.add_curve(group);
  doubt.add_curve(doubt.add_group(150));
  const std::vector<double> at{12, 90, 400, 3};
  std::vector<double> weights;
  doubt.weights(at, weights);
  ASSERT_EQ(weights.size(), at.size());
  for (std::size_t c = 0; c < at.size(); ++c) {
    auto more = at;
    auto less = at;
    more[c] += 1e-4;
    less[c] -= 1e-4;
    EXPECT_NEAR(weights[c], (doubt.energy(more) - doubt.energy(less)) / 2e-4, 1e-7) << c;
  }
}

}  // namespace
}  // namespace penpose::intent
