#include "core/animation/steady.h"

#include <algorithm>
#include <cmath>

#include "core/base/math.h"

namespace penpose::animation {
namespace {

using Places = std::vector<PxPoint>;

/// Root mean square distance over the chosen points.
double apart(const Places& a, const Places& b, std::span<const std::size_t> points) {
  double sum = 0;
  for (const std::size_t i : points) {
    const PxPoint d = a[i] - b[i];
    sum += d.x * d.x + d.y * d.y;
  }
  return std::sqrt(sum / static_cast<double>(points.size()));
}

/// 1 for differences that tremor explains: two places that each shake by tremor_px along both axes are on average two
/// tremors apart. Falls to nothing within two more.
double likeness(double difference_px, double tremor_px) {
  const double beyond = difference_px / tremor_px - 2.0;
  return beyond <= 0 ? 1.0 : base::exp(-beyond * beyond);
}

}  // namespace

void steady(StillTrack& track, std::span<const std::size_t> points, double tremor_px, std::size_t reach) {
  if (!(tremor_px > 0) || points.empty()) return;
  const auto& offsets = track.offsets;
  std::vector<Places> steadied(offsets.size());
  for (std::size_t f = 0; f < offsets.size(); ++f) {
    if (offsets[f].empty()) continue;
    Places sum(points.size());
    double weights = 0;
    const std::size_t last = std::min(offsets.size() - 1, f + reach);
    for (std::size_t g = f - std::min(f, reach); g <= last; ++g) {
      if (offsets[g].empty()) continue;
      const std::size_t frames = g < f ? f - g : g - f;
      const double nearness = 1.0 - static_cast<double>(frames) / static_cast<double>(reach + 1);
      const double w = nearness * track.confidence[g] * likeness(apart(offsets[f], offsets[g], points), tremor_px);
      for (std::size_t k = 0; k < points.size(); ++k) sum[k] = sum[k] + offsets[g][points[k]] * w;
      weights += w;
    }
    for (PxPoint& p : sum) p = p * (1.0 / weights);
    steadied[f] = std::move(sum);
  }
  for (std::size_t f = 0; f < steadied.size(); ++f) {
    for (std::size_t k = 0; k < steadied[f].size(); ++k) track.offsets[f][points[k]] = steadied[f][k];
  }
}

void settle(std::span<const double> tremor, std::vector<std::vector<double>>& rows, std::size_t reach) {
  std::vector<double> column(rows.size());
  for (std::size_t i = 0; i < tremor.size(); ++i) {
    if (!(tremor[i] > 0)) continue;
    for (std::size_t f = 0; f < rows.size(); ++f) column[f] = rows[f][i];
    for (std::size_t f = 0; f < rows.size(); ++f) {
      double sum = 0;
      double weights = 0;
      // Both sides reach equally far, so that a movement that begins at an end of the clip does not bend.
      const std::size_t side = std::min({reach, f, rows.size() - 1 - f});
      for (std::size_t g = f - side; g <= f + side; ++g) {
        const std::size_t frames = g < f ? f - g : g - f;
        const double nearness = 1.0 - static_cast<double>(frames) / static_cast<double>(reach + 1);
        const double w = nearness * likeness(std::abs(column[g] - column[f]), tremor[i]);
        sum += w * column[g];
        weights += w;
      }
      rows[f][i] = sum / weights;
    }
  }
}

void smooth_over_time(std::span<const double> times_s, double width_s, std::vector<std::vector<double>>& rows) {
  if (!(width_s > 0) || rows.empty()) return;
  std::vector<std::vector<double>> smoothed;
  std::size_t first = 0;
  for (std::size_t f = 0; f < rows.size(); ++f) {
    while (times_s[f] - times_s[first] >= width_s) ++first;
    // Near the ends of the clip both sides are cut alike, so that a steady movement stays where it is.
    const double side = std::min({width_s, times_s[f] - times_s.front(), times_s.back() - times_s[f]});
    std::vector<double> sum(rows[f].size(), 0.0);
    double weights = 0;
    for (std::size_t g = first; g < rows.size() && times_s[g] - times_s[f] < width_s; ++g) {
      const double distance = std::abs(times_s[g] - times_s[f]);
      if (distance > side * (1 + 1e-9)) continue;
      const double w = 1.0 - distance / width_s;
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += w * rows[g][i];
      weights += w;
    }
    for (double& value : sum) value /= weights;
    smoothed.push_back(std::move(sum));
  }
  rows = std::move(smoothed);
}

}  // namespace penpose::animation
