#include "core/animation/lids.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/animation/blinks.h"
#include "core/animation/statistics.h"
#include "core/animation/steady.h"

namespace penpose::animation {
namespace {

constexpr double k_column = 0.42;  ///< of what the tracker's own column says of eyes that stay narrow

/// How far an eye closes in a frame of a blink, 0..1: `strength` at its deepest.
double closed_at(const Blink& blink, const std::vector<double>& calm, std::size_t eye, double strength, std::size_t f) {
  if (!blink.calm_shape[eye]) return strength * blink.own_shape[f - blink.first];
  return strength / blink.calm_depth[eye] * (between(calm, blink.first, blink.last, f) - calm[f]);
}

/// What lasts: the calm opening without its blinks, in what the lids should do.
std::vector<double> lasting(const std::vector<double>& calm, const std::vector<Blink>& blinks, double full,
                            double tremor, std::size_t half) {
  std::vector<double> rest = calm;
  for (const Blink& blink : blinks) {
    for (std::size_t f = blink.first + 1; f < blink.last; ++f) rest[f] = between(calm, blink.first, blink.last, f);
  }
  std::vector<double> narrow;
  for (const double opening : rest) narrow.push_back(1.0 - opening);
  double gain = 1;
  if (full > 0) {
    // Where lasting dips go beyond what a blink shows, the points follow them, whatever they do in blinks.
    const double beyond = std::clamp((quantile(narrow, 0.98) / full - 1.0) / 0.5, 0.0, 1.0);
    gain = beyond + (1 - beyond) / std::min(full, 1.0);
  }
  // What is told larger than it was seen has to stand out of how the opening varies anyway.
  const double varies = spread(narrow);
  const double idle = (1 - 1 / gain) * varies;
  // Eyes are opened wide for a while, and beyond what is usual; what overshoots beside a blink is nothing of the kind.
  const std::vector<double> steady = running_median(narrow, half);
  for (std::size_t f = 0; f < narrow.size(); ++f) {
    const double wide = std::max(0.0, -steady[f] - varies - tremor);
    narrow[f] = narrow[f] > 0 ? gain * std::max(0.0, narrow[f] - idle) : -wide;
  }
  return narrow;
}

}  // namespace

std::vector<EyeCurves> eyes_of(std::span<const TrackedCurve> curves) {
  std::vector<EyeCurves> eyes;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (curves[c].meets && *curves[c].meets > c && *curves[c].meets < curves.size() &&
        curves[*curves[c].meets].meets == c) {
      eyes.push_back({c, *curves[c].meets});
    }
  }
  return eyes;
}

std::vector<std::array<std::size_t, 2>> points_across(const TrackedCurve& one, const TrackedCurve& other,
                                                      const TrackFrame& neutral) {
  const auto& p = neutral.points;
  const auto apart = [&](std::size_t a, std::size_t b) { return geometry::distance(p[a], p[b]); };
  std::vector<std::size_t> across = other.points;
  const auto& from = one.points;
  if (apart(from.front(), across.front()) + apart(from.back(), across.back()) >
      apart(from.front(), across.back()) + apart(from.back(), across.front())) {
    std::reverse(across.begin(), across.end());
  }
  std::vector<std::array<std::size_t, 2>> pairs;
  const std::size_t n = std::min(from.size(), across.size());
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const auto along = [&](const std::vector<std::size_t>& list) { return list[i * (list.size() - 1) / (n - 1)]; };
    pairs.push_back({along(from), along(across)});
  }
  if (pairs.empty()) pairs.push_back({from[from.size() / 2], across[across.size() / 2]});
  return pairs;
}

std::vector<double> openings(const StillTrack& still, const TrackFrame& neutral, const TrackedCurve& one,
                             const TrackedCurve& other) {
  const auto& p = neutral.points;
  const auto pairs = points_across(one, other, neutral);
  const PxPoint line = p[one.points.back()] - p[one.points.front()];
  const double length = std::sqrt(line.x * line.x + line.y * line.y);
  const PxPoint normal = length > 0 ? PxPoint{-line.y / length, line.x / length} : PxPoint{0, 1};
  std::vector<double> result;
  double last = 0;
  double sign = 0;
  for (const auto& [a, b] : pairs) {
    const PxPoint d = p[b] - p[a];
    sign += d.x * normal.x + d.y * normal.y;
    last += std::abs(d.x * normal.x + d.y * normal.y) / static_cast<double>(pairs.size());
  }
  sign = sign < 0 ? -1 : 1;
  for (const auto& offsets : still.offsets) {
    if (!offsets.empty()) {
      double sum = 0;
      for (const auto& [a, b] : pairs) {
        const PxPoint d = p[b] + offsets[b] - p[a] - offsets[a];
        sum += d.x * normal.x + d.y * normal.y;
      }
      last = sign * sum / static_cast<double>(pairs.size());
    }
    result.push_back(last);
  }
  return result;
}

EyeMotion find_eye_motion(std::span<const std::vector<double>> seen, std::span<const std::vector<double>> calm,
                          std::span<const double> confidence, double frames_per_s, std::span<const double> column,
                          double tremor_px, std::span<const double> doubt) {
  EyeMotion motion;
  std::vector<std::vector<double>> seen_shares;
  std::vector<std::vector<double>> calm_shares;
  for (std::size_t e = 0; e < seen.size(); ++e) {
    std::vector<double> open;
    for (std::size_t f = 0; f < calm[e].size(); ++f) {
      if (confidence[f] > 0) open.push_back(calm[e][f]);
    }
    const double usual = quantile(open, 0.5);
    motion.usual_px.push_back(usual);
    const auto shares = [&](const std::vector<double>& px) {
      std::vector<double> result;
      for (const double one : px) result.push_back(usual > 0 ? one / usual : 1.0);
      return result;
    };
    seen_shares.push_back(shares(seen[e]));
    calm_shares.push_back(shares(calm[e]));
  }
  motion.closed.resize(seen.size());
  if (seen.empty() || confidence.size() < 3) {
    for (auto& eye : motion.closed) eye.assign(confidence.size(), 0.0);
    return motion;
  }
  const double fps = frames_per_s > 0 ? frames_per_s : 30.0;
  const std::vector<Blink> blinks = find_blinks(seen_shares, calm_shares, confidence, fps, column);
  std::vector<double> depths;
  for (const Blink& blink : blinks) {
    motion.blinks.push_back(blink.peak);
    depths.push_back(*std::max_element(blink.depth.begin(), blink.depth.end()));
  }
  constexpr double k_usual_blink = 0.75;  // of all depths: most blinks close, some stop half-way
  constexpr double k_least_full = 0.25;   // no tracker closes lids by less, and one blink of a clip may be half a one
  motion.full_dip = depths.empty() ? 0.0 : std::clamp(quantile(depths, k_usual_blink), k_least_full, 1.0);
  for (std::size_t e = 0; e < seen.size(); ++e) {
    const double tremor = motion.usual_px[e] > 0 ? tremor_px / motion.usual_px[e] : 0.0;
    motion.closed[e] = lasting(calm_shares[e], blinks, motion.full_dip, tremor,
                               std::max<std::size_t>(1, static_cast<std::size_t>(0.35 * fps + 0.5)));
    if (column.size() == confidence.size()) {
      const double usual = quantile(column, 0.5) + spread(column);
      for (std::size_t f = 0; f < column.size(); ++f) {
        double& closed = motion.closed[e][f];
        if (closed >= 0) closed += k_column * std::max(0.0, column[f] - usual) * (1 - std::min(closed, 1.0));
      }
    }
    for (const Blink& blink : blinks) {
      const double most = *std::max_element(blink.depth.begin(), blink.depth.end());
      double mean = 0;
      for (const double depth : blink.depth) mean += depth / static_cast<double>(blink.depth.size());
      constexpr double k_takes_part = 0.4;
      const double depth = blink.depth[e] < k_takes_part * most ? 0.0 : mean > k_takes_part * most ? mean : most;
      const bool wink = *std::min_element(blink.depth.begin(), blink.depth.end()) < k_takes_part * most;
      const double strength = blink.backing * std::min(1.0, (wink && depth > 0 ? most : depth) / motion.full_dip);
      if (!(depth > 0)) continue;
      for (std::size_t f = blink.first; f <= blink.last; ++f) {
        const double here = closed_at(blink, calm_shares[e], e, strength, f);
        double& closed = motion.closed[e][f];
        closed += here;
      }
    }
    // A head that nods or looks up shows its eyes otherwise open, which is no fright.
    for (std::size_t f = 0; f < doubt.size(); ++f) {
      if (motion.closed[e][f] < 0) motion.closed[e][f] *= 1 - std::min(doubt[f], 1.0);
    }
    std::vector<std::vector<double>> rows;
    for (const double closed : motion.closed[e]) rows.push_back({std::min(closed, 1.0)});
    constexpr double k_sharp = 5;  // tremors; a blink bends by more
    const std::array<double, 1> sharp{k_sharp * tremor};
    round_corners(sharp, rows);
    std::vector<double> sharp_peaks = motion.closed[e];
    for (std::size_t f = 0; f < rows.size(); ++f) motion.closed[e][f] = rows[f][0];
    // A blink keeps its peak, however much else trembles.
    for (const Blink& blink : blinks) {
      for (std::size_t f = blink.peak - 1; f <= blink.peak + 1; ++f) {
        motion.closed[e][f] = std::max(motion.closed[e][f], std::min(sharp_peaks[f], 1.0));
      }
    }
  }
  return motion;
}

}  // namespace penpose::animation
