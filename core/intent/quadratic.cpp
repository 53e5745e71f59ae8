#include "core/intent/quadratic.h"

#include "core/posing/vector_math.h"

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
  return posing::dot(a.data(), b.data(), rows_) - posing::dot(a.data() + rows_, b.data() + rows_, slides_);
}

void Quadratic::finish(std::span<const std::size_t> only) {
  diagonal_.assign(variables_, 0.0);
  pull_.assign(variables_, 0.0);
  const std::size_t count = only.empty() ? variables_ : only.size();
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t j = only.empty() ? k : only[k];
    diagonal_[j] = product(column(j), column(j));
    pull_[j] = product(column(j), right_);
  }
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
  row.resize(variables_);
  for (std::size_t v = 0; v < variables_; ++v) row[v] = product(column(i), column(v));
}

}  // namespace penpose::intent
