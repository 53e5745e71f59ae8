#include "core/animation/signal/denoise.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/algebra/symmetric_eigen.h"
#include "core/animation/signal/trend.h"

namespace penpose::animation {
namespace {

/// Frames that show nothing are bridged, all others count by their confidence.
std::vector<double> trust_in(std::span<const double> confidence) {
  constexpr double k_least = 1e-3;
  std::vector<double> trust;
  for (const double c : confidence) trust.push_back(std::clamp(c, k_least, 1.0));
  return trust;
}

using Rows = std::vector<std::vector<double>>;

/// One row a frame: the offsets of the points, x and y in turn. A frame without a face repeats the one before.
Rows rows_of(const StillTrack& track, std::span<const std::size_t> points) {
  Rows rows;
  std::vector<double> last(2 * points.size(), 0.0);
  for (const auto& offsets : track.offsets) {
    for (std::size_t k = 0; k < points.size() && !offsets.empty(); ++k) {
      last[2 * k] = offsets[points[k]].x;
      last[2 * k + 1] = offsets[points[k]].y;
    }
    rows.push_back(last);
  }
  return rows;
}

void put_back(const Rows& rows, std::span<const std::size_t> points, StillTrack& track) {
  for (std::size_t f = 0; f < rows.size(); ++f) {
    auto& offsets = track.offsets[f];
    for (std::size_t k = 0; k < points.size() && !offsets.empty(); ++k) {
      offsets[points[k]] = {rows[f][2 * k], rows[f][2 * k + 1]};
    }
  }
}

/// The directions in which rows of `n` numbers vary, most first, one after the other, of length one.
std::vector<double> principal_axes(const Rows& rows, std::size_t n) {
  std::vector<double> mean(n, 0.0);
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < n; ++i) mean[i] += row[i] / static_cast<double>(rows.size());
  }
  std::vector<double> scatter(n * n, 0.0);
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < n; ++k) scatter[i * n + k] += (row[i] - mean[i]) * (row[k] - mean[k]);
    }
  }
  return algebra::symmetric_eigen(std::move(scatter), n).vectors;
}

/// denoise() of points that are few enough for a table of all of them against all.
void steady_few(StillTrack& track, std::span<const std::size_t> points, double tremor_px) {
  constexpr double k_strength = 2;  // times the deviation: what costs no more is taken for tremor
  const Rows rows = rows_of(track, points);
  const std::size_t n = 2 * points.size();
  const std::vector<double> axes = principal_axes(rows, n);
  Rows movements = rows;
  for (std::size_t f = 0; f < rows.size(); ++f) {
    for (std::size_t c = 0; c < n; ++c) {
      double along = 0;
      for (std::size_t i = 0; i < n; ++i) along += axes[c * n + i] * rows[f][i];
      movements[f][c] = along;
    }
  }
  follow_trend(trust_in(track.confidence), k_strength * k_tremor_deviation * tremor_px, movements);
  Rows steadied(rows.size(), std::vector<double>(n, 0.0));
  for (std::size_t f = 0; f < rows.size(); ++f) {
    for (std::size_t c = 0; c < n; ++c) {
      for (std::size_t i = 0; i < n; ++i) steadied[f][i] += axes[c * n + i] * movements[f][c];
    }
  }
  put_back(steadied, points, track);
}

}  // namespace

void denoise(StillTrack& track, std::span<const std::size_t> points, double tremor_px) {
  if (!(tremor_px > 0) || points.empty()) return;
  constexpr std::size_t k_most = 64;  // the lids of both eyes have 32 in MediaPipe's mesh, other curves some twenty
  const std::size_t runs = (points.size() + k_most - 1) / k_most;
  for (std::size_t run = 0; run < runs; ++run) {
    const std::size_t first = run * points.size() / runs;
    steady_few(track, points.subspan(first, (run + 1) * points.size() / runs - first), tremor_px);
  }
}

void denoise_rows(std::span<const double> confidence, double strength, std::vector<std::vector<double>>& rows) {
  follow_trend(trust_in(confidence), strength, rows);
}

void measure_from(StillTrack& track, std::size_t frame) {
  constexpr double k_believed = 0.5;
  const std::vector<geometry::PxPoint> zero = track.offsets[frame];
  for (auto& offsets : track.offsets) {
    for (std::size_t i = 0; i < offsets.size() && i < zero.size(); ++i) {
      offsets[i] = offsets[i] - zero[i] * k_believed;
    }
  }
}

void measure_from(StillTrack& track, std::span<const std::size_t> like) {
  // Frames in which the head was not found hold nothing.
  std::vector<std::size_t> frames;
  std::copy_if(like.begin(), like.end(), std::back_inserter(frames),
               [&](std::size_t f) { return f < track.offsets.size() && !track.offsets[f].empty(); });
  if (frames.empty()) return;
  std::vector<geometry::PxPoint> mean(track.offsets[frames[0]].size());
  for (const std::size_t f : frames) {
    for (std::size_t i = 0; i < std::min(mean.size(), track.offsets[f].size()); ++i) {
      mean[i] = mean[i] + track.offsets[f][i] * (1.0 / static_cast<double>(frames.size()));
    }
  }
  for (auto& offsets : track.offsets) {
    for (std::size_t i = 0; i < offsets.size() && i < mean.size(); ++i) offsets[i] = offsets[i] - mean[i];
  }
}

void denoise_parameters(std::span<const double> tremor, std::span<const double> confidence,
                        std::vector<std::vector<double>>& rows) {
  std::vector<std::size_t> moving;
  for (std::size_t i = 0; i < tremor.size(); ++i) {
    const bool moves = std::any_of(rows.begin(), rows.end(), [&](const auto& row) { return row[i] != rows[0][i]; });
    if (moves && tremor[i] > 0) moving.push_back(i);
  }
  Rows columns;  // in units of their tremor
  for (const auto& row : rows) {
    std::vector<double>& column = columns.emplace_back();
    for (const std::size_t i : moving) column.push_back(row[i] / tremor[i]);
  }
  follow_trend(trust_in(confidence), 1.0, columns);
  for (std::size_t f = 0; f < rows.size(); ++f) {
    for (std::size_t k = 0; k < moving.size(); ++k) rows[f][moving[k]] = columns[f][k] * tremor[moving[k]];
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
