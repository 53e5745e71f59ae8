#include "core/animation/face/lids.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/animation/signal/blinks.h"
#include "core/animation/signal/denoise.h"
#include "core/animation/signal/statistics.h"

namespace penpose::animation {
namespace {

constexpr double k_column = 0.51;       ///< of what the tracker's own column says of eyes that stay narrow
constexpr double k_usual_open = 0.6;    ///< of the clip the eyes are no wider than usual: they blink, and look down
constexpr double k_surely_full = 0.85;  ///< of the usual depth of a blink closes: trackers are no surer

/// What a blink does to each eye, 0..1.
std::vector<double> strengths_of(const Blink& blink, double full) {
  const double most = *std::max_element(blink.depth.begin(), blink.depth.end());
  std::vector<double> part;
  double depth = 0;
  double parts = 0;
  for (const double one : blink.depth) {
    // An eye that dips by far less than the other does not take part: a wink.
    part.push_back(most > 0 ? std::clamp((one / most - 0.3) / 0.2, 0.0, 1.0) : 0.0);
    depth += part.back() * one;
    parts += part.back();
  }
  if (!(parts > 0) || !(full > 0)) return part;
  const double strength = blink.sure * std::min(1.0, depth / parts / (k_surely_full * full));
  for (double& one : part) one *= strength;
  return part;
}

/// What lasts of the openings without the blinks: their trends. What all eyes do together is told by all of them.
std::vector<std::vector<double>> lasting_openings(const std::vector<std::vector<double>>& seen,
                                                  const std::vector<Blink>& blinks, std::span<const double> confidence,
                                                  double tremor) {
  constexpr double k_strength = 2;  // times the deviation: what costs no more is taken for tremor
  const std::size_t eyes = seen.size();
  std::vector<std::vector<double>> rest = seen;
  for (const Blink& blink : blinks) {
    for (std::size_t e = 0; e < eyes; ++e) {
      for (std::size_t f = blink.first; f <= blink.last; ++f) {
        rest[e][f] += blink.depth[e] * blink.shape[f - blink.first];
      }
    }
  }
  std::vector<std::vector<double>> rows;
  const double all = std::sqrt(static_cast<double>(eyes));
  for (std::size_t f = 0; f < confidence.size(); ++f) {
    std::vector<double>& row = rows.emplace_back(eyes + 1, 0.0);
    for (std::size_t e = 0; e < eyes; ++e) row[eyes] += rest[e][f] / static_cast<double>(eyes);
    for (std::size_t e = 0; e < eyes; ++e) row[e] = rest[e][f] - row[eyes];
    row[eyes] *= all;
  }
  denoise_rows(confidence, k_strength * tremor, rows);
  for (std::size_t f = 0; f < rows.size(); ++f) {
    for (std::size_t e = 0; e < eyes; ++e) rest[e][f] = rows[f][e] + rows[f][eyes] / all;
  }
  return rest;
}

/// What lasts, in what the lids should do.
std::vector<double> lasting(const std::vector<double>& calm, double full, double tremor, std::size_t half) {
  std::vector<double> narrow;
  for (const double opening : calm) narrow.push_back(1.0 - opening);
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
      // In widths of the eye, of which less depends on how large the head is thought to be.
      const PxPoint now = line + offsets[one.points.back()] - offsets[one.points.front()];
      const double width = std::sqrt(now.x * now.x + now.y * now.y);
      constexpr double k_least_width = 0.5;
      if (length > 0) last *= length / std::max(width, k_least_width * length);
    }
    result.push_back(last);
  }
  return result;
}

LidPoints points_of_lids(const StillTrack& still, const TrackFrame& neutral, const TrackedCurve& one,
                         const TrackedCurve& other) {
  const auto& p = neutral.points;
  const PxPoint line = p[one.points.back()] - p[one.points.front()];
  const double length = std::sqrt(line.x * line.x + line.y * line.y);
  const PxPoint normal = length > 0 ? PxPoint{-line.y / length, line.x / length} : PxPoint{0, 1};
  LidPoints points;
  for (const TrackedCurve* curve : {&one, &other}) {
    for (std::size_t k = 1; k + 1 < curve->points.size(); ++k) {
      std::vector<double>& across = points.emplace_back();
      double last = 0;
      for (const auto& offsets : still.offsets) {
        if (!offsets.empty()) {
          // From the middle between the corners: less of it depends on where the head is thought to be.
          const PxPoint corners = (offsets[one.points.front()] + offsets[one.points.back()]) * 0.5;
          const PxPoint moved = offsets[curve->points[k]] - corners;
          last = moved.x * normal.x + moved.y * normal.y;
        }
        across.push_back(last);
      }
    }
  }
  return points;
}

EyeMotion find_eye_motion(std::span<const std::vector<double>> seen, std::span<const LidPoints> points,
                          std::span<const double> confidence, double frames_per_s, std::span<const double> column,
                          double tremor_px, std::span<const double> doubt) {
  EyeMotion motion;
  std::vector<std::vector<double>> shares;
  double usual_px = 0;
  for (const auto& eye : seen) {
    std::vector<double> open;
    for (std::size_t f = 0; f < eye.size(); ++f) {
      if (confidence[f] > 0) open.push_back(eye[f]);
    }
    const double usual = quantile(open, 0.5);
    motion.usual_px.push_back(usual);
    usual_px += usual / static_cast<double>(seen.size());
    std::vector<double>& share = shares.emplace_back();
    for (const double one : eye) share.push_back(usual > 0 ? one / usual : 1.0);
  }
  motion.closed.resize(seen.size());
  if (seen.empty() || confidence.size() < 3) {
    for (auto& eye : motion.closed) eye.assign(confidence.size(), 0.0);
    return motion;
  }
  const double fps = frames_per_s > 0 ? frames_per_s : 30.0;
  const double tremor = usual_px > 0 ? tremor_px / usual_px : 0.0;
  std::vector<Blink> blinks = find_blinks(shares, points, confidence, fps, column);
  auto calm = lasting_openings(shares, blinks, confidence, tremor);
  for (std::size_t e = 0; e < seen.size(); ++e) {
    // Blinks and tremor do not count in what is usual.
    std::vector<double> open;
    for (std::size_t f = 0; f < calm[e].size(); ++f) {
      if (confidence[f] > 0) open.push_back(calm[e][f]);
    }
    const double usual = quantile(open, k_usual_open);
    if (!(usual > 0)) continue;
    motion.usual_px[e] *= usual;
    for (double& one : calm[e]) one /= usual;
    for (Blink& blink : blinks) blink.depth[e] /= usual;
  }
  std::vector<double> depths;
  for (const Blink& blink : blinks) {
    motion.blinks.push_back(blink.peak);
    depths.push_back(*std::max_element(blink.depth.begin(), blink.depth.end()));
  }
  constexpr double k_usual_blink = 0.75;  // of all depths: most blinks close, some stop half-way
  constexpr double k_least_full = 0.25;   // no tracker closes lids by less, and one blink of a clip may be half a one
  motion.full_dip = depths.empty() ? 0.0 : std::clamp(quantile(depths, k_usual_blink), k_least_full, 1.0);
  const auto half = std::max<std::size_t>(1, static_cast<std::size_t>(0.35 * fps + 0.5));
  for (std::size_t e = 0; e < seen.size(); ++e) {
    std::vector<double>& closed = motion.closed[e];
    closed = lasting(calm[e], motion.full_dip, tremor, half);
    if (column.size() == confidence.size()) {
      const double usual = quantile(column, 0.5) + spread(column);
      for (std::size_t f = 0; f < column.size(); ++f) {
        if (closed[f] >= 0) closed[f] += k_column * std::max(0.0, column[f] - usual) * (1 - std::min(closed[f], 1.0));
      }
    }
    // A head that nods or looks up shows its eyes otherwise open, which is no fright.
    for (std::size_t f = 0; f < doubt.size(); ++f) {
      if (closed[f] < 0) closed[f] *= 1 - std::min(doubt[f], 1.0);
    }
    std::vector<std::vector<double>> rows;
    for (const double one : closed) rows.push_back({std::min(one, 1.0)});
    constexpr double k_sharp = 5;  // tremors
    const std::array<double, 1> sharp{k_sharp * tremor};
    round_corners(sharp, rows);
    for (std::size_t f = 0; f < rows.size(); ++f) closed[f] = rows[f][0];
  }
  for (const Blink& blink : blinks) {
    const std::vector<double> strength = strengths_of(blink, motion.full_dip);
    for (std::size_t e = 0; e < seen.size(); ++e) {
      for (std::size_t f = blink.first; f <= blink.last; ++f) {
        double& closed = motion.closed[e][f];
        closed += strength[e] * blink.lids[f - blink.first] * (1 - std::clamp(closed, 0.0, 1.0));
      }
    }
  }
  return motion;
}

}  // namespace penpose::animation
