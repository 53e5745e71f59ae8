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
  /// A run of rows and slides whose sum of squares counts by itself: a curve's.
  struct Part {
    std::size_t row = 0, rows = 0, slide = 0, slides = 0;
  };

  /// Makes room for `variables` columns of `rows` and `slides` numbers, all zero.
  void reset(std::size_t variables, std::size_t rows, std::size_t slides);
  /// Keeps derivatives for each of these parts instead of for all. Call it after reset and before finish.
  void split(std::span<const Part> parts);
  [[nodiscard]] std::size_t part_count() const { return parts_.size(); }
  /// curvature, pull and constant of one part. Precondition: of curvature, one of the variables is prepared or both are
  /// the same.
  [[nodiscard]] double part_curvature(std::size_t part, std::size_t i, std::size_t j) const {
    return part_curvatures(i, j)[part];
  }
  /// The same of all parts for two variables, one of them prepared.
  [[nodiscard]] const double* part_curvatures(std::size_t i, std::size_t j) const {
    const std::size_t count = parts_.size();
    if (i == j) return part_diagonals_.data() + i * count;
    return part_grams_[i].empty() ? part_grams_[j].data() + i * count : part_grams_[i].data() + j * count;
  }
  /// The same, of variables of which none need be prepared.
  [[nodiscard]] std::vector<double> part_products_of(std::size_t i, std::size_t j) const;
  [[nodiscard]] const double* part_pulls(std::size_t i) const { return part_pulls_.data() + i * parts_.size(); }
  [[nodiscard]] double part_pull(std::size_t part, std::size_t i) const { return part_pulls(i)[part]; }
  [[nodiscard]] double part_constant(std::size_t part) const { return part_constants_[part]; }
  /// Computes the second derivatives of variable i with all others for each part, once.
  void prepare_parts(std::size_t i);

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
  [[nodiscard]] double part_product(std::size_t part, std::span<const double> a, std::span<const double> b) const;
  /// out[asked_[k] * part_count() + part] = part_product(part, a, column(asked_[k])), several at once.
  void part_products(std::size_t part, std::span<const double> a, std::span<double> out) const;
  [[nodiscard]] std::size_t stride() const { return rows_ + slides_; }

  std::size_t variables_ = 0, rows_ = 0, slides_ = 0;
  std::vector<double> columns_, right_, diagonal_, pull_;
  double constant_ = 0;
  std::vector<std::vector<double>> gram_;  ///< prepared rows; others are empty
  std::vector<std::size_t> asked_;         ///< columns to multiply with one
  std::vector<Part> parts_;
  std::vector<double> part_diagonals_, part_pulls_, part_constants_;  ///< a run of parts a variable
  std::vector<std::vector<double>> part_grams_;                       ///< prepared rows; others are empty
};

}  // namespace penpose::intent
