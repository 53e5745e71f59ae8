#include "core/posing/vector_math.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "core/geometry/simd.h"

namespace penpose::posing {
namespace {

using geometry::Double4;

/// Four doubles at any address.
Double4 at(const double* p) {
  Double4 value;
  std::memcpy(&value, p, sizeof value);
  return value;
}
void put(double* p, Double4 value) { std::memcpy(p, &value, sizeof value); }

double sum_of(const Double4& lanes) { return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]); }

}  // namespace

double dot(const double* a, const double* b, std::size_t count) {
  Double4 sum = geometry::splat(0.0);
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4) sum += at(a + i) * at(b + i);
  double total = sum_of(sum);
  for (; i < count; ++i) total += a[i] * b[i];
  return total;
}

std::array<double, 4> dots(const double* a, const std::array<const double*, 4>& b, std::size_t count) {
  // Four sums that do not wait for each other.
  Double4 s0 = geometry::splat(0.0), s1 = s0, s2 = s0, s3 = s0;
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4) {
    const Double4 one = at(a + i);
    s0 += one * at(b[0] + i);
    s1 += one * at(b[1] + i);
    s2 += one * at(b[2] + i);
    s3 += one * at(b[3] + i);
  }
  std::array<double, 4> totals{sum_of(s0), sum_of(s1), sum_of(s2), sum_of(s3)};
  for (; i < count; ++i) {
    for (std::size_t k = 0; k < 4; ++k) totals[k] += a[i] * b[k][i];
  }
  return totals;
}

void multiply(const double* a, const double* b, double* out, std::size_t count) {
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4) put(out + i, at(a + i) * at(b + i));
  for (; i < count; ++i) out[i] = a[i] * b[i];
}

void add_scaled(double factor, const double* a, double* out, std::size_t count) {
  const Double4 f = geometry::splat(factor);
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4) put(out + i, at(out + i) + f * at(a + i));
  for (; i < count; ++i) out[i] += factor * a[i];
}

double weighted_lengths(const double* residuals, std::span<const double> weights, double softness) {
  Double4 sum = geometry::splat(0.0);
  const Double4 soft = geometry::splat(softness * softness);
  const double* block = residuals;
  for (std::size_t i = 0; i < weights.size(); i += k_block_points, block += k_block_numbers) {
    const Double4 squared =
        at(block) * at(block) + at(block + 4) * at(block + 4) + at(block + 8) * at(block + 8) + soft;
    const Double4 length = {std::sqrt(squared[0]), std::sqrt(squared[1]), std::sqrt(squared[2]), std::sqrt(squared[3])};
    sum += at(weights.data() + i) * length;
  }
  return sum_of(sum);
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
  Double4 sum = geometry::splat(0.0);
  Double4 other = geometry::splat(0.0);
  Double4 third = geometry::splat(0.0);
  for (const Run& run : runs_) {
    for (std::size_t i = run.begin; i < run.end; i += k_block_numbers) {
      sum += at(a + i) * at(b + i);
      other += at(a + i + 4) * at(b + i + 4);
      third += at(a + i + 8) * at(b + i + 8);
    }
  }
  return sum_of(sum + other + third);
}

void Column::multiply(const double* b, double* out) const {
  for (const Run& run : runs_)
    posing::multiply(values_.data() + run.begin, b + run.begin, out + run.begin, run.end - run.begin);
}

void Column::add_to(double factor, double* out) const {
  for (const Run& run : runs_) add_scaled(factor, values_.data() + run.begin, out + run.begin, run.end - run.begin);
}

}  // namespace penpose::posing
