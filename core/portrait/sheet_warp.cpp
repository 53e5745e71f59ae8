#include "core/portrait/sheet_warp.h"

#include <algorithm>
#include <cmath>

#include "core/base/math.h"
#include "core/portrait/face_view.h"

namespace penpose::portrait {
namespace {

constexpr double k_smoothing = 3e-3;
constexpr double k_step = 2.0;  // px, of a derivative

/// r^2 log r of a distance, lengths in faces.
double bend(const PxPoint& a, const PxPoint& b) {
  const double dx = (a.x - b.x) / k_face_px, dy = (a.y - b.y) / k_face_px;
  const double square = dx * dx + dy * dy;
  return square > 0.0 ? 0.5 * square * base::log(square) : 0.0;
}

/// Solves A x = b of n unknowns and two right sides in place, with the largest pivots. False where there is none.
bool eliminate(std::vector<double>& a, std::vector<PxPoint>& b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t best = k;
    for (std::size_t r = k + 1; r < n; ++r) {
      if (std::abs(a[r * n + k]) > std::abs(a[best * n + k])) best = r;
    }
    if (!(std::abs(a[best * n + k]) > 1e-12)) return false;
    if (best != k) {
      std::swap_ranges(a.begin() + static_cast<std::ptrdiff_t>(k * n),
                       a.begin() + static_cast<std::ptrdiff_t>(k * n + n),
                       a.begin() + static_cast<std::ptrdiff_t>(best * n));
      std::swap(b[k], b[best]);
    }
    for (std::size_t r = k + 1; r < n; ++r) {
      const double share = a[r * n + k] / a[k * n + k];
      if (share == 0.0) continue;
      for (std::size_t c = k; c < n; ++c) a[r * n + c] -= share * a[k * n + c];
      b[r] = b[r] - b[k] * share;
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t c = k + 1; c < n; ++c) b[k] = b[k] - b[c] * a[k * n + c];
    b[k] = b[k] * (1.0 / a[k * n + k]);
  }
  return true;
}

}  // namespace

SheetWarp::SheetWarp(std::span<const PxPoint> points, std::span<const PxPoint> there)
    : points_(points.begin(), points.end()) {
  const std::size_t n = points.size(), size = n + 3;
  std::vector<double> a(size * size, 0.0);
  std::vector<PxPoint> b(size);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) a[i * size + k] = bend(points[i], points[k]);
    a[i * size + i] += k_smoothing;
    const std::array<double, 3> affine = {1.0, points[i].x / k_face_px, points[i].y / k_face_px};
    for (std::size_t k = 0; k < 3; ++k) a[i * size + n + k] = a[(n + k) * size + i] = affine[k];
    b[i] = there[i] - points[i];
  }
  if (n < 3 || !eliminate(a, b)) b.assign(size, PxPoint{});
  weights_.assign(b.begin(), b.begin() + static_cast<std::ptrdiff_t>(n));
  std::copy_n(b.begin() + static_cast<std::ptrdiff_t>(n), 3, affine_.begin());
}

PxPoint SheetWarp::offset(const PxPoint& p) const {
  PxPoint sum = affine_[0] + affine_[1] * (p.x / k_face_px) + affine_[2] * (p.y / k_face_px);
  for (std::size_t i = 0; i < points_.size(); ++i) sum = sum + weights_[i] * bend(p, points_[i]);
  return sum;
}

std::array<double, 4> SheetWarp::derivative(const PxPoint& p) const {
  const PxPoint dx = offset(p + PxPoint{k_step, 0}) - offset(p - PxPoint{k_step, 0});
  const PxPoint dy = offset(p + PxPoint{0, k_step}) - offset(p - PxPoint{0, k_step});
  constexpr double k_width = 2.0 * k_step;
  return {1.0 + dx.x / k_width, dy.x / k_width, dx.y / k_width, 1.0 + dy.y / k_width};
}

}  // namespace penpose::portrait
