#include "core/posing/vector_math.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/algebra/simd.h"
#include "core/algebra/vectors.h"

namespace penpose::posing {
using algebra::Double4;
using algebra::load;

double weighted_lengths(const double* residuals, std::span<const double> weights, double softness) {
  Double4 sum = algebra::splat(0.0);
  const Double4 soft = algebra::splat(softness * softness);
  const double* block = residuals;
  for (std::size_t i = 0; i < weights.size(); i += k_block_points, block += k_block_numbers) {
    const Double4 squared =
        load(block) * load(block) + load(block + 4) * load(block + 4) + load(block + 8) * load(block + 8) + soft;
    const Double4 length = {std::sqrt(squared[0]), std::sqrt(squared[1]), std::sqrt(squared[2]), std::sqrt(squared[3])};
    sum += load(weights.data() + i) * length;
  }
  return algebra::sum_of(sum);
}

Column::Column(Residuals values) : values_(std::move(values)) {
  for (std::uint32_t begin = 0; begin < values_.size(); begin += k_block_numbers) {
    const auto block = std::span(values_).subspan(begin, k_block_numbers);
    if (std::all_of(block.begin(), block.end(), [](double v) { return v == 0.0; })) continue;
    const auto end = static_cast<std::uint32_t>(begin + k_block_numbers);
    if (!runs_.empty() && runs_.back().end == begin) {
      runs_.back().end = end;
    } else {
      runs_.push_back({begin, end});
    }
  }
}

void Column::scale(double factor) {
  for (double& value : values_) value *= factor;
}

double Column::dot(const double* b) const { return dot_within(values_.data(), b); }

double Column::dot_within(const double* a, const double* b) const {
  Double4 sum = algebra::splat(0.0);
  Double4 other = algebra::splat(0.0);
  Double4 third = algebra::splat(0.0);
  for (const Run& run : runs_) {
    for (std::size_t i = run.begin; i < run.end; i += k_block_numbers) {
      sum += load(a + i) * load(b + i);
      other += load(a + i + 4) * load(b + i + 4);
      third += load(a + i + 8) * load(b + i + 8);
    }
  }
  return algebra::sum_of(sum + other + third);
}

void Column::multiply(const double* b, double* out) const {
  for (const Run& run : runs_)
    algebra::multiply(values_.data() + run.begin, b + run.begin, out + run.begin, run.end - run.begin);
}

void Column::add_to(double factor, double* out) const {
  for (const Run& run : runs_)
    algebra::add_scaled(factor, values_.data() + run.begin, out + run.begin, run.end - run.begin);
}

}  // namespace penpose::posing
