#include "core/posing/simplex.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace penpose::posing {
namespace {

/// Any function of u as an objective without an image.
class Plain final : public Objective {
 public:
  Plain(std::size_t dimension, std::function<double(std::span<const double>)> function)
      : dimension_(dimension), function_(std::move(function)) {}
  [[nodiscard]] std::size_t dimension() const override { return dimension_; }
  [[nodiscard]] std::size_t image_size() const override { return 0; }
  void make_image(std::span<const double>, std::span<double>) override {}
  void shift_image(std::size_t, double, std::span<double>) override {}
  double value(std::span<const double> u, std::span<const double>) override {
    ++evaluations;
    for (const double x : u) {
      EXPECT_GE(x, 0.0);
      EXPECT_LE(x, 1.0);
    }
    return function_(u);
  }
  int evaluations = 0;

 private:
  std::size_t dimension_;
  std::function<double(std::span<const double>)> function_;
};

/// |A u - b| with the residual as its image; counts nothing from scratch but make_image.
class Affine final : public Objective {
 public:
  [[nodiscard]] std::size_t dimension() const override { return 2; }
  [[nodiscard]] std::size_t image_size() const override { return 3; }
  void make_image(std::span<const double> u, std::span<double> image) override {
    for (std::size_t k = 0; k < 3; ++k) image[k] = a_[0][k] * u[0] + a_[1][k] * u[1] - b_[k];
  }
  void shift_image(std::size_t i, double delta, std::span<double> image) override {
    for (std::size_t k = 0; k < 3; ++k) image[k] += delta * a_[i][k];
  }
  double value(std::span<const double> u, std::span<const double> image) override {
    // The image that the simplex carries along is that of the point it belongs to.
    std::array<double, 3> fresh{};
    make_image(u, fresh);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(image[k], fresh[k], 1e-9);
    return std::sqrt(image[0] * image[0] + image[1] * image[1] + image[2] * image[2]);
  }

 private:
  std::array<std::array<double, 3>, 2> a_{{{1, 2, 0}, {0.5, -1, 3}}};
  std::array<double, 3> b_{0.6, -0.3, 2.4};
};

TEST(Simplex, FindsTheBottomOfAValley) {
  Plain valley(2, [](std::span<const double> u) {
    const double x = 4 * u[0] - 2;
    const double y = 4 * u[1] - 1;
    return 100 * (y - x * x) * (y - x * x) + (1 - x) * (1 - x);
  });
  std::vector<double> u{0.2, 0.6};
  std::vector<double> image;
  SimplexWorkspace work;
  SimplexOptions options;
  options.size_tolerance = 1e-7;
  options.value_tolerance = 1e-9;
  const auto result = run_simplex(valley, options, u, image, work);
  EXPECT_NEAR(u[0], 0.75, 1e-3);
  EXPECT_NEAR(u[1], 0.5, 1e-3);
  EXPECT_EQ(result.evaluations, static_cast<std::size_t>(valley.evaluations));
}

TEST(Simplex, StaysInTheBoxAndReachesItsCorner) {
  Plain slope(3, [](std::span<const double> u) { return 2 * u[0] - u[1] + 0.5 * u[2] + 10; });
  std::vector<double> u{0.5, 0.5, 0.5};
  std::vector<double> image;
  SimplexWorkspace work;
  run_simplex(slope, SimplexOptions{}, u, image, work);
  EXPECT_NEAR(u[0], 0, 1e-3);
  EXPECT_NEAR(u[1], 1, 1e-3);
  EXPECT_NEAR(u[2], 0, 1e-3);
}

TEST(Simplex, CarriesImagesThatBelongToTheirPoints) {
  Affine affine;
  std::vector<double> u{0.1, 0.1};
  std::vector<double> image(3);
  affine.make_image(u, image);
  SimplexWorkspace work;
  const auto result = run_simplex(affine, SimplexOptions{}, u, image, work);
  EXPECT_LT(result.value, 0.6);
  std::array<double, 3> fresh{};
  affine.make_image(u, fresh);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(image[k], fresh[k]);
}

TEST(Simplex, NeverEndsAboveItsStartAndKeepsItsBudget) {
  for (const std::size_t budget : {5U, 17U, 60U}) {
    Plain bumps(4, [](std::span<const double> u) {
      double sum = 0;
      for (std::size_t i = 0; i < u.size(); ++i)
        sum += std::sin(40 * u[i] + static_cast<double>(i)) + (u[i] - 0.3) * (u[i] - 0.3);
      return sum;
    });
    std::vector<double> u{0.9, 0.1, 0.4, 0.7};
    const std::vector<double> start = u;
    std::vector<double> image;
    SimplexWorkspace work;
    SimplexOptions options;
    options.max_evaluations = budget;
    const double before = bumps.value(start, {});
    const auto result = run_simplex(bumps, options, u, image, work);
    EXPECT_LE(result.value, before);
    EXPECT_DOUBLE_EQ(bumps.value(u, {}), result.value);
    EXPECT_LE(result.evaluations, budget);
  }
}

TEST(Simplex, WithoutVariablesItOnlyEvaluates) {
  Plain constant(0, [](std::span<const double>) { return 3.0; });
  SimplexWorkspace work;
  std::vector<double> none;
  EXPECT_EQ(run_simplex(constant, SimplexOptions{}, none, none, work).value, 3.0);
}

}  // namespace
}  // namespace penpose::posing
