#include "core/prior/shrinkage.h"

#include <gtest/gtest.h>
#include <vector>

namespace penpose::prior {
namespace {

struct Spectrum {
  std::vector<double> values;
  [[nodiscard]] double trace() const {
    double sum = 0;
    for (const double v : values) sum += v;
    return sum;
  }
  [[nodiscard]] double square() const {
    double sum = 0;
    for (const double v : values) sum += v * v;
    return sum;
  }
};

TEST(Shrinkage, IsTheClosedFormOfChenAndOthers) {
  // n = 20, p = 4, S = diag(9, 1, 0, 0): (1/2 * 82 + 100) / ((21 - 1/2) (82 - 100/4)).
  EXPECT_DOUBLE_EQ(oracle_shrinkage(20, 4, 10, 82), 141.0 / (20.5 * 57.0));
  // n = 10, p = 2, S = diag(2, 1): (0 + 9) / (10 * 0.5) is above one.
  EXPECT_EQ(oracle_shrinkage(10, 2, 3, 5), 1);
}

// The closed form is where the paper's iteration (equations 21 and 22) settles: the oracle's formula with the estimate
// of the round before in place of the true covariance.
TEST(Shrinkage, IsWhereThePapersIterationSettles) {
  for (const Spectrum& s : {Spectrum{{9, 1, 0, 0}}, Spectrum{{5, 3, 1, 0.5, 0.1, 0}}, Spectrum{{1, 1, 0.2}}}) {
    const std::size_t n = 40;
    const auto p = static_cast<double>(s.values.size());
    double rho = 0.5;
    for (int round = 0; round < 500; ++round) {
      const double trace = s.trace();
      const double mixed = (1 - rho) * s.square() + rho * trace * trace / p;
      rho = ((1 - 2 / p) * mixed + trace * trace) / ((n + 1 - 2 / p) * mixed + (1 - n / p) * trace * trace);
    }
    EXPECT_NEAR(oracle_shrinkage(n, s.values.size(), s.trace(), s.square()), rho, 1e-9);
  }
}

TEST(Shrinkage, GrowsLessWithMoreSamplesAndIsAllWhereNothingStandsOut) {
  const Spectrum s{{9, 1, 0.5, 0.1}};
  double before = 1.1;
  for (const std::size_t n : {4U, 8U, 16U, 64U, 100000U}) {
    const double rho = oracle_shrinkage(n, 4, s.trace(), s.square());
    EXPECT_LT(rho, before) << n;
    before = rho;
  }
  EXPECT_LT(before, 1e-4);
  EXPECT_EQ(oracle_shrinkage(50, 3, 6, 12), 1) << "all directions spread alike";
  EXPECT_EQ(oracle_shrinkage(5, 1, 2, 4), 1) << "one number has nothing to be compared with";
  EXPECT_EQ(oracle_shrinkage(5, 3, 0, 0), 1);
}

}  // namespace
}  // namespace penpose::prior
