#include "core/animation/head/face_depths.h"

#include <algorithm>
#include <cmath>

#include "core/animation/signal/statistics.h"

namespace penpose::animation {
namespace {

/// Where, in the neutral frame, a point that lies one px deeper than was thought seems to be.
PxPoint seen_of_depth(const HeadTurn& turn) {
  const auto& r = turn.rotation;
  const double determinant = r[0][0] * r[1][1] - r[1][0] * r[0][1];
  if (!(std::abs(determinant) > 0.1)) return {};
  return {(r[1][1] * r[2][0] - r[1][0] * r[2][1]) / determinant, (r[0][0] * r[2][1] - r[0][1] * r[2][0]) / determinant};
}

}  // namespace

void learn_depths(StillTrack& track, std::span<const std::size_t> but, double extent_px) {
  constexpr double k_usual_difference = 0.1;  // of the stable points' extent: so far faces differ
  constexpr double k_alike_frames = 10;       // neighbouring frames say the same
  constexpr int k_rounds = 4;
  std::vector<std::size_t> frames;
  std::vector<PxPoint> seen;
  for (std::size_t f = 0; f < track.offsets.size(); ++f) {
    if (track.offsets[f].empty()) continue;
    frames.push_back(f);
    seen.push_back(seen_of_depth(track.turns[f]));
  }
  const double prior = k_usual_difference * extent_px;
  if (frames.size() < 3 || !(prior > 0)) return;
  const std::size_t points = track.offsets[frames[0]].size();
  for (std::size_t p = 0; p < points; ++p) {
    if (std::find(but.begin(), but.end(), p) != but.end()) continue;
    std::vector<double> x;
    std::vector<double> y;
    for (const std::size_t f : frames) {
      x.push_back(track.offsets[f][p].x);
      y.push_back(track.offsets[f][p].y);
    }
    double depth = 0;
    PxPoint rest{quantile(x, 0.5), quantile(y, 0.5)};
    for (int round = 0; round < k_rounds; ++round) {
      std::vector<double> left_x;
      std::vector<double> left_y;
      for (std::size_t i = 0; i < frames.size(); ++i) {
        left_x.push_back(x[i] - depth * seen[i].x);
        left_y.push_back(y[i] - depth * seen[i].y);
      }
      rest = {quantile(left_x, 0.5), quantile(left_y, 0.5)};
      std::vector<double> away;
      for (std::size_t i = 0; i < frames.size(); ++i) {
        away.push_back(geometry::distance({left_x[i], left_y[i]}, rest));
      }
      const double usual = std::max(quantile(away, 0.5), 1e-9 * extent_px);
      double squares = k_alike_frames * usual * usual / (prior * prior);
      double along = 0;
      for (std::size_t i = 0; i < frames.size(); ++i) {
        const double trust = usual / std::max(usual, away[i]);
        squares += trust * (seen[i].x * seen[i].x + seen[i].y * seen[i].y);
        along += trust * (seen[i].x * (x[i] - rest.x) + seen[i].y * (y[i] - rest.y));
      }
      depth = along / squares;
    }
    for (std::size_t i = 0; i < frames.size(); ++i) {
      PxPoint& offset = track.offsets[frames[i]][p];
      offset = offset - seen[i] * depth;
    }
  }
}

}  // namespace penpose::animation
