#include "core/portrait/reading/stretches.h"

#include <algorithm>
#include <limits>

namespace penpose::portrait {
namespace {

constexpr std::size_t k_steps = 24;
constexpr std::size_t k_least_steps = 4;

std::size_t step_of(double share) {
  return static_cast<std::size_t>(std::clamp(share, 0.0, 1.0) * static_cast<double>(k_steps) + 0.5);
}

}  // namespace

std::size_t Stretches::near(std::size_t curve, double from, double to) {
  std::size_t first = step_of(from), last = step_of(to);
  if (last < first + k_least_steps) {
    const std::size_t middle = std::clamp((first + last) / 2, k_least_steps / 2, k_steps - k_least_steps / 2);
    first = middle - k_least_steps / 2;
    last = first + k_least_steps;
  }
  if (first <= 1 && last + 1 >= k_steps) return curve * FaceView::stretches_per_curve();
  const auto [at, is_new] = finer_.try_emplace({curve, first, last}, all_.size());
  if (is_new) {
    all_.push_back(face_.stretch(curve, static_cast<double>(first) / static_cast<double>(k_steps),
                                 static_cast<double>(last) / static_cast<double>(k_steps)));
  }
  return at->second;
}

double share_nearest(const Trace& line, PxPoint p) {
  double least = std::numeric_limits<double>::infinity(), share = 0;
  for (std::size_t i = 0; i + 1 < k_points; ++i) {
    const PxPoint a{line[2 * i], line[2 * i + 1]}, b{line[2 * i + 2], line[2 * i + 3]};
    const double f = geometry::nearest_share(p, a, b);
    const double apart = geometry::distance(p, a + (b - a) * f);
    if (apart < least) {
      least = apart;
      share = (static_cast<double>(i) + f) / static_cast<double>(k_points - 1);
    }
  }
  return share;
}

}  // namespace penpose::portrait
