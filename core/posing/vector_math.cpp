#include "core/posing/vector_math.h"

#include <cmath>

#include "core/geometry/simd.h"

namespace penpose::posing {
namespace {

using geometry::Double4;

/// Four doubles at any address; the type tells the compiler that they need no alignment and may alias plain doubles.
using Loose4 = double __attribute__((vector_size(32), aligned(8), may_alias));
const Loose4& at(const double* p) { return *reinterpret_cast<const Loose4*>(p); }
Loose4& at(double* p) { return *reinterpret_cast<Loose4*>(p); }

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

void multiply(const double* a, const double* b, double* out, std::size_t count) {
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4) at(out + i) = at(a + i) * at(b + i);
  for (; i < count; ++i) out[i] = a[i] * b[i];
}

void add_scaled(double factor, const double* a, double* out, std::size_t count) {
  const Double4 f = geometry::splat(factor);
  std::size_t i = 0;
  for (; i + 4 <= count; i += 4) at(out + i) += f * at(a + i);
  for (; i < count; ++i) out[i] += factor * a[i];
}

double weighted_lengths(const double* residuals, const double* weights, std::size_t stride) {
  const double* x = residuals;
  const double* y = residuals + stride;
  const double* z = residuals + 2 * stride;
  Double4 sum = geometry::splat(0.0);
  for (std::size_t i = 0; i < stride; i += 4) {
    const Double4 squared = at(x + i) * at(x + i) + at(y + i) * at(y + i) + at(z + i) * at(z + i);
    const Double4 length = {std::sqrt(squared[0]), std::sqrt(squared[1]), std::sqrt(squared[2]), std::sqrt(squared[3])};
    sum += at(weights + i) * length;
  }
  return sum_of(sum);
}

}  // namespace penpose::posing
