#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace penpose::intent {

/// The error of the drawn curves near one pose, as a quadratic form of a few variables z:
///
///   E(z) = |R z - r|^2 - |P z - p|^2
///
/// R has one row for each direction of each point, already divided by the doubt. P removes the error that
/// points can slide away along their lines: minimising over the modes of sliding leaves this difference (a Schur
/// complement), so E is never below zero. One column is kept for each variable. The matrix of all pairs is never made,
/// so a model of hundreds of controls costs only as much as the variables in question.
class Quadratic {
 public:
  /// Makes room for `variables` columns of `rows` and `slides` numbers, all zero.
  void reset(std::size_t variables, std::size_t rows, std::size_t slides);

  [[nodiscard]] std::size_t variables() const { return variables_; }
  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t slides() const { return slides_; }
  [[nodiscard]] std::span<double> column(std::size_t j) { return {columns_.data() + j * stride(), stride()}; }
  [[nodiscard]] std::span<const double> column(std::size_t j) const {
    return {columns_.data() + j * stride(), stride()};
  }
  /// r and p, concatenated.
  [[nodiscard]] std::span<double> right() { return right_; }
  [[nodiscard]] std::span<const double> right() const { return right_; }

  /// Call it once columns and right side are filled. `only`: the variables in question; empty: all.
  void finish(std::span<const std::size_t> only = {});
  /// Half the second derivative of E by two variables. Costs one product, or none where one of them is prepared.
  [[nodiscard]] double curvature(std::size_t i, std::size_t j) const;
  /// Computes the second derivatives of variable i with all others, once.
  void prepare(std::size_t i);
  [[nodiscard]] double curvature(std::size_t i) const { return diagonal_[i]; }
  /// Half the negative derivative of E by variable i at z = 0.
  [[nodiscard]] double pull(std::size_t i) const { return pull_[i]; }
  /// E(0).
  [[nodiscard]] double constant() const { return constant_; }
  /// The inner product of E on two runs of rows and slides.
  [[nodiscard]] double product(std::span<const double> a, std::span<const double> b) const;

 private:
  /// out[asked_[k]] = product(a, column(asked_[k])), several at once.
  void products(std::span<const double> a, std::span<double> out) const;
  [[nodiscard]] std::size_t stride() const { return rows_ + slides_; }

  std::size_t variables_ = 0, rows_ = 0, slides_ = 0;
  std::vector<double> columns_, right_, diagonal_, pull_;
  double constant_ = 0;
  std::vector<std::vector<double>> gram_;  ///< prepared rows; others are empty
  std::vector<std::size_t> asked_;         ///< columns to multiply with one
};

}  // namespace penpose::intent
