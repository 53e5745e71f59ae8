#include "core/algebra/vectors.h"

#include <gtest/gtest.h>
#include <vector>

#include "tests/support/random.h"

namespace penpose::algebra {
namespace {

TEST(Vectors, WorksForAnyCount) {
  for (std::size_t count = 0; count < 19; ++count) {
    const auto a = tests::random_numbers(count, 1);
    const auto b = tests::random_numbers(count, 2);
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += a[i] * b[i];
    EXPECT_NEAR(dot(a.data(), b.data(), count), sum, 1e-14);

    std::vector<double> out(count + 1, 7);
    multiply(a.data(), b.data(), out.data(), count);
    for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(out[i], a[i] * b[i]);
    EXPECT_EQ(out[count], 7);

    out.assign(count + 1, 7);
    add_scaled(-3, a.data(), out.data(), count);
    for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(out[i], 7 + -3 * a[i]);
    EXPECT_EQ(out[count], 7);
  }
}

TEST(Vectors, AddsItsLanesInAFixedOrder) {
  // The sum that the contract spells out, number by number: four lanes, then pairs of them, then the rest.
  const auto a = tests::random_numbers(11, 3);
  const auto b = tests::random_numbers(11, 4);
  std::array<double, 4> lane{};
  for (std::size_t i = 0; i < 8; ++i) lane[i % 4] += a[i] * b[i];
  double sum = (lane[0] + lane[1]) + (lane[2] + lane[3]);
  for (std::size_t i = 8; i < 11; ++i) sum += a[i] * b[i];
  EXPECT_EQ(dot(a.data(), b.data(), 11), sum);
}

TEST(Vectors, FourSumsAtOnceAreThoseOfOneEach) {
  for (const std::size_t count : {0U, 3U, 4U, 11U}) {
    const auto a = tests::random_numbers(count, 5);
    std::array<std::vector<double>, 4> b;
    for (std::size_t k = 0; k < 4; ++k) b[k] = tests::random_numbers(count, 6 + k);
    const auto all = dots(a.data(), {b[0].data(), b[1].data(), b[2].data(), b[3].data()}, count);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(all[k], dot(a.data(), b[k].data(), count));
  }
}

}  // namespace
}  // namespace penpose::algebra
