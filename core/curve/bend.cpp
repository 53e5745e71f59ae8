#include "core/curve/bend.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/curve/polyline.h"

namespace penpose::curve {
namespace {

/// Corners of a line that bends.
constexpr std::size_t k_bending = 64;

}  // namespace

std::vector<double> pull_weights(std::span<const PxPoint> line, double held, double reach, bool closed) {
  std::vector<double> weights(line.size(), 1.0);
  if (reach == 0.0) return weights;
  const std::vector<double> along = cumulative_length<PxPoint>(line);
  const double length = along.back();
  for (std::size_t i = 0; i < line.size(); ++i) {
    double off = std::abs(along[i] - held);
    if (closed) off = std::min(off, length - off);
    const double x = length > 0.0 ? off / (reach * length) : 0.0;
    const double left = std::max(0.0, 1.0 - x * x);
    weights[i] = left * left;
  }
  return weights;
}

double nearest_along(std::span<const PxPoint> line, std::span<const double> cumulative, PxPoint to) {
  double best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double u = geometry::nearest_share(to, line[i], line[i + 1]);
    const double apart = geometry::distance(to, line[i] + (line[i + 1] - line[i]) * u);
    if (apart >= least) continue;
    least = apart;
    best = cumulative[i] + u * (cumulative[i + 1] - cumulative[i]);
  }
  return best;
}

double nearest_along(std::span<const PxPoint> line, PxPoint to) {
  return nearest_along(line, cumulative_length<PxPoint>(line), to);
}

std::optional<std::vector<PxPoint>> bent(std::span<const PxPoint> line, PxPoint at, PxPoint by, double reach,
                                         bool closed) {
  std::vector<PxPoint> out(line.begin(), line.end());
  if (out.size() < k_bending) {
    const auto even = resample<PxPoint>(line, k_bending);
    if (!even) return std::nullopt;
    out = *even;
  }
  const std::vector<double> weights = pull_weights(out, nearest_along(out, at), reach, closed);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = out[i] + by * weights[i];
  return out;
}

}  // namespace penpose::curve
