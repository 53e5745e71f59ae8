#include "core/animation/steady.h"

#include <algorithm>
#include <cmath>

#include "core/animation/trend.h"

namespace penpose::animation {
namespace {

/// Tremor is spread evenly over its reach; the standard deviation of that is 1 / sqrt(3).
constexpr double k_deviation = 0.58;

/// Frames that show nothing are bridged, all others count by their confidence.
std::vector<double> trust_in(std::span<const double> confidence) {
  constexpr double k_least = 1e-3;
  std::vector<double> trust;
  for (const double c : confidence) trust.push_back(std::clamp(c, k_least, 1.0));
  return trust;
}

}  // namespace

void steady(StillTrack& track, std::span<const std::size_t> points, double tremor_px) {
  if (!(tremor_px > 0) || points.empty()) return;
  std::vector<std::vector<double>> rows;
  std::vector<double> last(2 * points.size(), 0.0);
  for (const auto& offsets : track.offsets) {
    for (std::size_t k = 0; k < points.size() && !offsets.empty(); ++k) {
      last[2 * k] = offsets[points[k]].x;
      last[2 * k + 1] = offsets[points[k]].y;
    }
    rows.push_back(last);
  }
  follow_trend(trust_in(track.confidence), k_deviation * tremor_px, rows);
  for (std::size_t f = 0; f < rows.size(); ++f) {
    auto& offsets = track.offsets[f];
    for (std::size_t k = 0; k < points.size() && !offsets.empty(); ++k) {
      offsets[points[k]] = {rows[f][2 * k], rows[f][2 * k + 1]};
    }
  }
}

void settle(std::span<const double> tremor, std::span<const double> confidence,
            std::vector<std::vector<double>>& rows) {
  TrendOptions options;
  options.bend_cost = 4;
  options.free_bend = 3;
  options.iterations = 150;
  const std::vector<double> trust = trust_in(confidence);
  for (std::size_t i = 0; i < tremor.size(); ++i) {
    std::vector<std::vector<double>> column;
    for (const auto& row : rows) column.push_back({row[i]});
    if (std::all_of(column.begin(), column.end(), [&](const auto& value) { return value == column[0]; })) continue;
    follow_trend(trust, tremor[i], column, options);
    for (std::size_t f = 0; f < rows.size(); ++f) rows[f][i] = column[f][0];
  }
}

void round_corners(std::span<const double> sharp, std::vector<std::vector<double>>& rows) {
  constexpr int k_steps = 6;  // a corner is spread over some three frames
  const std::size_t n = rows.size();
  if (n < 2) return;
  std::vector<double> before(n);
  for (std::size_t i = 0; i < sharp.size(); ++i) {
    if (!(sharp[i] > 0)) continue;
    for (int step = 0; step < k_steps; ++step) {
      for (std::size_t f = 0; f < n; ++f) before[f] = rows[f][i];
      for (std::size_t f = 0; f < n; ++f) {
        // Before its first frame and after its last a clip stands still.
        const double bend = before[f == 0 ? 0 : f - 1] - 2 * before[f] + before[f + 1 == n ? f : f + 1];
        const double ratio = bend / sharp[i];
        const double spared = 1 + ratio * ratio;
        rows[f][i] += 0.25 * bend / (spared * spared);
      }
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
