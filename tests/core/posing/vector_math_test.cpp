#include "core/posing/vector_math.h"

#include <cmath>
#include <gtest/gtest.h>

#include "tests/support/models/test_rigs.h"
#include "tests/support/random.h"

namespace penpose::posing {
namespace {

TEST(Residuals, HoldFourPointsABlock) {
  EXPECT_EQ(residual_index(0, 0), 0U);
  EXPECT_EQ(residual_index(3, 0), 3U);
  EXPECT_EQ(residual_index(0, 1), 4U);
  EXPECT_EQ(residual_index(2, 2), 10U);
  EXPECT_EQ(residual_index(4, 0), 12U);
  EXPECT_EQ(residual_index(9, 1), 24U + 4U + 1U);
}

TEST(Residuals, LengthsAreWeightedAndSummed) {
  Residuals residuals(24, 0.0);
  const auto put = [&](std::size_t point, double x, double y, double z) {
    residuals[residual_index(point, 0)] = x;
    residuals[residual_index(point, 1)] = y;
    residuals[residual_index(point, 2)] = z;
  };
  put(0, 2, 3, 6);   // 7
  put(2, 0, -5, 0);  // 5
  put(3, 1, 2, 2);   // 3, but without weight
  put(5, 4, 4, -7);  // 9
  const std::vector<double> weights{1, 1, 2, 0, 1, 0.5, 0, 0};
  EXPECT_EQ(weighted_lengths(residuals.data(), weights), 7 + 10 + 4.5);
  EXPECT_EQ(weighted_lengths(residuals.data(), {}), 0);
}

TEST(Residuals, SoftLengthsAreSquaresWhereTheyAreSmall) {
  Residuals residuals(12, 0.0);
  const std::vector<double> weights{2, 0, 0, 0};
  const auto at = [&](double length) {
    residuals[residual_index(0, 1)] = length;
    return weighted_lengths(residuals.data(), weights, 0.5);
  };
  EXPECT_EQ(at(0), 1.0);
  EXPECT_NEAR(at(1.2), 2.6, 1e-15);  // 5, 12, 13
  EXPECT_NEAR((at(0.02) - at(0)) / (at(0.01) - at(0)), 4, 0.01);
  EXPECT_NEAR(at(101) - at(100), 2, 1e-4);  // far out they are lengths
}

TEST(Column, DoesWhatAWholeColumnWould) {
  tests::Random random(5);
  for (int run = 0; run < 50; ++run) {
    const std::size_t blocks = 1 + random.index(8);
    const std::size_t size = blocks * k_block_numbers;
    Residuals dense(size, 0.0);
    for (std::size_t block = 0; block < blocks; ++block) {
      if (random.index(2) == 0) continue;
      for (std::size_t i = 0; i < k_block_numbers; ++i)
        dense[block * k_block_numbers + i] = random.index(3) == 0 ? 0.0 : random(-1, 1);
    }
    const Column column(dense);
    EXPECT_EQ(column.values(), dense);
    const auto b = tests::random_numbers(size, 6);
    double sum = 0;
    for (std::size_t i = 0; i < size; ++i) sum += dense[i] * b[i];
    EXPECT_NEAR(column.dot(b.data()), sum, 1e-13);

    std::vector<double> out = tests::random_numbers(size, 7);
    const auto before = out;
    column.add_to(0.5, out.data());
    for (std::size_t i = 0; i < size; ++i) EXPECT_EQ(out[i], before[i] + 0.5 * dense[i]);

    std::vector<double> product(size, 0.0);
    column.multiply(b.data(), product.data());
    double within = 0;
    const auto c = tests::random_numbers(size, 8);
    for (std::size_t i = 0; i < size; ++i) {
      EXPECT_EQ(product[i], dense[i] * b[i]);
      const std::size_t block = i / k_block_numbers * k_block_numbers;
      bool any = false;
      for (std::size_t k = 0; k < k_block_numbers; ++k) any |= dense[block + k] != 0.0;
      if (any) within += c[i] * b[i];
    }
    EXPECT_NEAR(column.dot_within(c.data(), b.data()), within, 1e-13);

    Column scaled(dense);
    scaled.scale(-2);
    for (std::size_t i = 0; i < size; ++i) EXPECT_EQ(scaled.values()[i], -2 * dense[i]);
    EXPECT_NEAR(scaled.dot(b.data()), -2 * sum, 1e-13);
  }
}

TEST(Column, OfNothingIsNothing) {
  const Column empty;
  EXPECT_EQ(empty.dot(nullptr), 0);
  const Column zero(Residuals(24, 0.0));
  EXPECT_EQ(zero.dot(std::vector<double>(24, 1.0).data()), 0);
}

}  // namespace
}  // namespace penpose::posing
