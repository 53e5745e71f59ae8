#include "core/algebra/vectors.h"

#include <numeric>

#include "core/algebra/simd.h"

namespace penpose::algebra {

double dot(const double* a, const double* b, std::size_t count) {
  Double4 sum = splat(0.0);
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4) sum += load(a + i) * load(b + i);
  double total = sum_of(sum);
  for (; i < count; ++i) total += a[i] * b[i];
  return total;
}

double dot_in_order(const double* a, const double* b, std::size_t count) {
  return std::inner_product(a, a + count, b, 0.0);
}

std::array<double, 4> dots(const double* a, const std::array<const double*, 4>& b, std::size_t count) {
  // Four sums that do not wait for each other.
  Double4 s0 = splat(0.0), s1 = s0, s2 = s0, s3 = s0;
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4) {
    const Double4 one = load(a + i);
    s0 += one * load(b[0] + i);
    s1 += one * load(b[1] + i);
    s2 += one * load(b[2] + i);
    s3 += one * load(b[3] + i);
  }
  std::array<double, 4> totals{sum_of(s0), sum_of(s1), sum_of(s2), sum_of(s3)};
  for (; i < count; ++i) {
    for (std::size_t k = 0; k < 4; ++k) totals[k] += a[i] * b[k][i];
  }
  return totals;
}

void multiply(const double* a, const double* b, double* out, std::size_t count) {
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4) store(out + i, load(a + i) * load(b + i));
  for (; i < count; ++i) out[i] = a[i] * b[i];
}

void add_scaled(double factor, const double* a, double* out, std::size_t count) {
  const Double4 f = splat(factor);
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4) store(out + i, load(out + i) + f * load(a + i));
  for (; i < count; ++i) out[i] += factor * a[i];
}

}  // namespace penpose::algebra
