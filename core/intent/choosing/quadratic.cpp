#include "core/intent/choosing/quadratic.h"

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
  parts_.clear();
}

void Quadratic::split(std::span<const Part> parts) { parts_.assign(parts.begin(), parts.end()); }

void Quadratic::part_products(std::size_t part, std::span<const double> a, std::span<double> out) const {
  const Part& one = parts_[part];
  const std::size_t count = parts_.size();
  const double* own_rows = a.data() + one.row;
  const double* own_slides = a.data() + rows_ + one.slide;
  const auto rows = [&](std::size_t k) { return column(asked_[k]).data() + one.row; };
  const auto slides = [&](std::size_t k) { return column(asked_[k]).data() + rows_ + one.slide; };
  std::size_t k = 0;
  for (; k + 4 <= asked_.size(); k += 4) {
    const auto r = algebra::dots(own_rows, {rows(k), rows(k + 1), rows(k + 2), rows(k + 3)}, one.rows);
    const auto p = algebra::dots(own_slides, {slides(k), slides(k + 1), slides(k + 2), slides(k + 3)}, one.slides);
    for (std::size_t m = 0; m < 4; ++m) out[asked_[k + m] * count + part] = r[m] - p[m];
  }
  for (; k < asked_.size(); ++k)
    out[asked_[k] * count + part] =
        algebra::dot(own_rows, rows(k), one.rows) - algebra::dot(own_slides, slides(k), one.slides);
}

void Quadratic::prepare_parts(std::size_t i) {
  auto& row = part_grams_[i];
  if (!row.empty()) return;
  row.assign(parts_.size() * variables_, 0.0);
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    // What moves nothing of a curve has nothing in common with anything there.
    if (part_curvatures(i, i)[p] == 0.0) continue;
    part_products(p, column(i), row);
  }
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
  if (parts_.empty()) {
    products(right_, pull_);
    for (const std::size_t j : asked_) diagonal_[j] = product(column(j), column(j));
    constant_ = product(right_, right_);
    return;
  }
  part_diagonals_.assign(parts_.size() * variables_, 0.0);
  part_pulls_.assign(parts_.size() * variables_, 0.0);
  part_constants_.resize(parts_.size());
  part_grams_.resize(variables_);
  for (auto& row : part_grams_) row.clear();
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    part_constants_[p] = part_product(p, right_, right_);
    part_products(p, right_, part_pulls_);
    for (const std::size_t j : asked_) part_diagonals_[j * parts_.size() + p] = part_product(p, column(j), column(j));
  }
}

double Quadratic::part_product(std::size_t part, std::span<const double> a, std::span<const double> b) const {
  const Part& one = parts_[part];
  return algebra::dot(a.data() + one.row, b.data() + one.row, one.rows) -
         algebra::dot(a.data() + rows_ + one.slide, b.data() + rows_ + one.slide, one.slides);
}

std::vector<double> Quadratic::part_products_of(std::size_t i, std::size_t j) const {
  std::vector<double> out(parts_.size());
  for (std::size_t p = 0; p < out.size(); ++p) out[p] = part_product(p, column(i), column(j));
  return out;
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
