#include "core/intent/reading/quadratic.h"

#include <array>

#include "core/algebra/vectors.h"

namespace penpose::intent {

void Quadratic::reset(std::size_t variables, std::size_t rows, std::size_t slides) {
  variables_ = variables;
  rows_ = rows;
  slides_ = slides;
  columns_.assign(variables * stride(), 0.0);
  right_.assign(stride(), 0.0);
  gram_.resize(variables);
  for (auto& row : gram_) row.clear();
}

double Quadratic::product(std::span<const double> a, std::span<const double> b) const {
  return algebra::dot(a.data(), b.data(), rows_) - algebra::dot(a.data() + rows_, b.data() + rows_, slides_);
}

void Quadratic::products(std::span<const double> a, std::span<double> out) const {
  std::size_t k = 0;
  for (; k + 4 <= asked_.size(); k += 4) {
    std::array<const double*, 4> rows;
    std::array<const double*, 4> slides;
    for (std::size_t m = 0; m < 4; ++m) {
      rows[m] = column(asked_[k + m]).data();
      slides[m] = rows[m] + rows_;
    }
    const auto r = algebra::dots(a.data(), rows, rows_);
    const auto p = algebra::dots(a.data() + rows_, slides, slides_);
    for (std::size_t m = 0; m < 4; ++m) out[asked_[k + m]] = r[m] - p[m];
  }
  for (; k < asked_.size(); ++k) out[asked_[k]] = product(a, column(asked_[k]));
}

void Quadratic::finish(std::span<const std::size_t> only) {
  diagonal_.assign(variables_, 0.0);
  pull_.assign(variables_, 0.0);
  asked_.clear();
  const std::size_t count = only.empty() ? variables_ : only.size();
  for (std::size_t k = 0; k < count; ++k) asked_.push_back(only.empty() ? k : only[k]);
  products(right_, pull_);
  for (const std::size_t j : asked_) diagonal_[j] = product(column(j), column(j));
  constant_ = product(right_, right_);
}

double Quadratic::curvature(std::size_t i, std::size_t j) const {
  if (i == j) return diagonal_[i];
  if (!gram_[i].empty()) return gram_[i][j];
  if (!gram_[j].empty()) return gram_[j][i];
  return product(column(i), column(j));
}

void Quadratic::prepare(std::size_t i) {
  auto& row = gram_[i];
  if (!row.empty()) return;
  asked_.clear();
  for (std::size_t v = 0; v < variables_; ++v) {
    if (v == i || gram_[v].empty()) asked_.push_back(v);
  }
  row.resize(variables_);
  for (std::size_t v = 0; v < variables_; ++v) {
    if (v != i && !gram_[v].empty()) row[v] = gram_[v][i];
  }
  products(column(i), row);
}

}  // namespace penpose::intent
