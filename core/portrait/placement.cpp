#include "core/portrait/placement.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace penpose::portrait {
namespace {

struct Extent {
  PxPoint low{1e300, 1e300}, high{-1e300, -1e300};
  void add(const Trace& trace) {
    for (std::size_t i = 0; i < k_points; ++i) {
      low = {std::min(low.x, trace[2 * i]), std::min(low.y, trace[2 * i + 1])};
      high = {std::max(high.x, trace[2 * i]), std::max(high.y, trace[2 * i + 1])};
    }
  }
  [[nodiscard]] PxPoint middle() const { return (low + high) * 0.5; }
  [[nodiscard]] PxPoint size() const { return high - low; }
  [[nodiscard]] double diagonal() const { return std::sqrt(size().x * size().x + size().y * size().y); }
};

}  // namespace

Trace Placement::operator()(const Trace& trace) const {
  Trace out{};
  for (std::size_t i = 0; i < k_points; ++i) {
    const PxPoint p = (*this)(PxPoint{trace[2 * i], trace[2 * i + 1]});
    out[2 * i] = p.x;
    out[2 * i + 1] = p.y;
  }
  return out;
}

double Placement::scale() const { return std::sqrt(along * along + across * across); }

std::vector<Placement> first_placements(const FaceView& face, std::span<const Trace> lines) {
  Extent drawn;
  for (const Trace& line : lines) drawn.add(line);
  std::vector<Placement> out;
  for (const auto& group : face.groups()) {
    Extent goal;
    for (const std::size_t c : group) goal.add(face.curve(c).rest);
    for (const double scale :
         {goal.diagonal() / drawn.diagonal(), goal.size().x / drawn.size().x, goal.size().y / drawn.size().y}) {
      if (std::isfinite(scale) && scale > 0.0) out.push_back({scale, 0, goal.middle() - drawn.middle() * scale});
    }
  }
  return out;
}

std::vector<Placement> turned_about(const Placement& placement, std::span<const Trace> lines) {
  constexpr std::array<double, 2> k_turn = {0.990268, 0.139173};  // cosine and sine of 8 degrees
  Extent drawn;
  for (const Trace& line : lines) drawn.add(line);
  std::vector<Placement> out;
  for (const double sine : {k_turn[1], -k_turn[1]}) {
    Placement one{placement.along * k_turn[0] - placement.across * sine,
                  placement.along * sine + placement.across * k_turn[0],
                  {0, 0}};
    one.shift = placement(drawn.middle()) - one(drawn.middle());
    out.push_back(one);
  }
  return out;
}

Placement placed(std::span<const Match> matches, const Placement& from) {
  constexpr int k_rounds = 8;
  constexpr double k_least = 4.0;  // px: nearer than this is near
  Placement best = from;
  std::vector<double> weights;
  for (const Match& match : matches) weights.insert(weights.end(), k_points, match.weight);
  std::vector<double> weighed = weights;
  for (int round = 0; round < k_rounds; ++round) {
    double sum = 0;
    PxPoint a{0, 0}, b{0, 0};
    std::size_t k = 0;
    for (const Match& match : matches) {
      for (std::size_t i = 0; i < k_points; ++i, ++k) {
        sum += weighed[k];
        a = a + PxPoint{match.line[2 * i], match.line[2 * i + 1]} * weighed[k];
        b = b + PxPoint{match.goal[2 * i], match.goal[2 * i + 1]} * weighed[k];
      }
    }
    if (!(sum > 0.0)) return from;
    a = a * (1.0 / sum);
    b = b * (1.0 / sum);
    double square = 0, goals = 0, along = 0, across = 0;
    k = 0;
    for (const Match& match : matches) {
      for (std::size_t i = 0; i < k_points; ++i, ++k) {
        const double px = match.line[2 * i] - a.x, py = match.line[2 * i + 1] - a.y;
        const double gx = match.goal[2 * i] - b.x, gy = match.goal[2 * i + 1] - b.y;
        square += weighed[k] * (px * px + py * py);
        goals += weighed[k] * (gx * gx + gy * gy);
        along += weighed[k] * (px * gx + py * gy);
        across += weighed[k] * (px * gy - py * gx);
      }
    }
    const double turn = std::sqrt(along * along + across * across);
    if (!(square > 0.0 && goals > 0.0 && turn > 0.0)) return from;
    // As large as the goals, which least squares of deviations alone would fall short of.
    const double scale = std::sqrt(goals / square);
    best.along = scale * along / turn;
    best.across = scale * across / turn;
    best.shift = PxPoint{0, 0};
    best.shift = b - best(a);
    k = 0;
    for (const Match& match : matches) {
      const Trace there = best(match.line);
      for (std::size_t i = 0; i < k_points; ++i, ++k) {
        const double dx = there[2 * i] - match.goal[2 * i], dy = there[2 * i + 1] - match.goal[2 * i + 1];
        weighed[k] = weights[k] / std::max(k_least, std::sqrt(dx * dx + dy * dy));
      }
    }
  }
  return best;
}

}  // namespace penpose::portrait
