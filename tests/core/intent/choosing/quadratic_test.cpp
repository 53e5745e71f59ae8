#include "core/intent/choosing/quadratic.h"

#include <cmath>
#include <gtest/gtest.h>

#include "tests/support/models/test_rigs.h"

namespace penpose::intent {
namespace {

constexpr std::size_t k_variables = 5, k_rows = 12, k_slides = 2;
using Row = std::array<double, k_rows>;

/// Rows that ask for values of variables, and two ways in which all rows may slide at the cost of their square.
struct Sliding {
  std::array<Row, k_variables> columns{};
  Row right{};
  std::array<Row, k_slides> modes{};

  explicit Sliding(std::uint64_t seed) {
    tests::Random random(seed);
    for (auto& column : columns) {
      for (double& v : column) v = random(-1, 1);
    }
    for (double& v : right) v = random(-3, 3);
    for (auto& mode : modes) {
      for (double& v : mode) v = random(-1, 1);
    }
  }

  /// |R z - r + M s|^2 + |s|^2, minimised over s by descending along one after the other until nothing changes.
  [[nodiscard]] double energy(std::span<const double> z) const {
    Row off{};
    for (std::size_t i = 0; i < k_rows; ++i) {
      off[i] = -right[i];
      for (std::size_t j = 0; j < k_variables; ++j) off[i] += columns[j][i] * z[j];
    }
    std::array<double, k_slides> s{};
    for (int sweep = 0; sweep < 2000; ++sweep) {
      for (std::size_t m = 0; m < k_slides; ++m) {
        double slope = s[m];
        double curvature = 1;
        for (std::size_t i = 0; i < k_rows; ++i) {
          slope += modes[m][i] * off[i];
          curvature += modes[m][i] * modes[m][i];
        }
        const double by = -slope / curvature;
        s[m] += by;
        for (std::size_t i = 0; i < k_rows; ++i) off[i] += by * modes[m][i];
      }
    }
    double sum = s[0] * s[0] + s[1] * s[1];
    for (const double o : off) sum += o * o;
    return sum;
  }

  /// The same with the modes taken out: P = L^-1 M' R with L L' = I + M' M.
  void fill(Quadratic& q) const {
    q.reset(k_variables, k_rows, k_slides);
    double a = 1, b = 0, c = 1;
    for (std::size_t i = 0; i < k_rows; ++i) {
      a += modes[0][i] * modes[0][i];
      b += modes[0][i] * modes[1][i];
      c += modes[1][i] * modes[1][i];
    }
    const double l00 = std::sqrt(a), l10 = b / l00, l11 = std::sqrt(c - l10 * l10);
    const auto put = [&](const Row& row, std::span<double> out) {
      double m0 = 0, m1 = 0;
      for (std::size_t i = 0; i < k_rows; ++i) {
        out[i] = row[i];
        m0 += modes[0][i] * row[i];
        m1 += modes[1][i] * row[i];
      }
      out[k_rows] = m0 / l00;
      out[k_rows + 1] = (m1 - l10 * out[k_rows]) / l11;
    };
    for (std::size_t j = 0; j < k_variables; ++j) put(columns[j], q.column(j));
    put(right, q.right());
  }
};

double energy(const Quadratic& q, std::span<const double> z) {
  double sum = q.constant();
  for (std::size_t i = 0; i < q.variables(); ++i) {
    sum -= 2 * q.pull(i) * z[i];
    for (std::size_t j = 0; j < q.variables(); ++j) sum += q.curvature(i, j) * z[i] * z[j];
  }
  return sum;
}

TEST(Quadratic, IsTheLeastOverAllThatMaySlide) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Sliding sliding(seed);
    Quadratic q;
    sliding.fill(q);
    q.finish();
    tests::Random random(seed + 10);
    for (int run = 0; run < 20; ++run) {
      std::array<double, k_variables> z{};
      for (double& v : z) v = random(-2, 2);
      EXPECT_NEAR(energy(q, z), sliding.energy(z), 1e-9 * (1 + sliding.energy(z)));
    }
  }
}

TEST(Quadratic, PreparingChangesNoCurvature) {
  const Sliding sliding(4);
  Quadratic plain;
  Quadratic prepared;
  sliding.fill(plain);
  sliding.fill(prepared);
  plain.finish();
  prepared.finish();
  prepared.prepare(1);
  prepared.prepare(3);
  for (std::size_t i = 0; i < k_variables; ++i) {
    EXPECT_EQ(plain.curvature(i), plain.curvature(i, i));
    for (std::size_t j = 0; j < k_variables; ++j) {
      EXPECT_NEAR(plain.curvature(i, j), prepared.curvature(i, j), 1e-12);
      EXPECT_NEAR(plain.curvature(i, j), plain.curvature(j, i), 1e-12);
    }
  }
}

TEST(Quadratic, OnlyWhatIsInQuestionIsFinished) {
  const Sliding sliding(5);
  Quadratic all;
  Quadratic some;
  sliding.fill(all);
  sliding.fill(some);
  all.finish();
  const std::vector<std::size_t> only{0, 4};
  some.finish(only);
  for (const std::size_t j : only) {
    EXPECT_EQ(some.pull(j), all.pull(j));
    EXPECT_EQ(some.curvature(j), all.curvature(j));
  }
  EXPECT_EQ(some.constant(), all.constant());
}

TEST(Quadratic, ResetForgetsWhatWasThere) {
  Quadratic q;
  Sliding(6).fill(q);
  q.finish();
  q.prepare(0);
  q.reset(2, 3, 1);
  q.column(0)[0] = 2;
  q.column(1)[0] = 3;
  q.column(1)[3] = 1;
  q.right()[0] = 5;
  q.finish();
  EXPECT_EQ(q.curvature(0, 1), 6);
  EXPECT_EQ(q.curvature(1), 8) << "what slides is taken back";
  EXPECT_EQ(q.pull(0), 10);
  EXPECT_EQ(q.constant(), 25);
}

}  // namespace
}  // namespace penpose::intent
