#include "ui/app/tour/tour_line.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/curve/polyline.h"

namespace penpose::app {
namespace {

constexpr std::size_t k_places = 48;
/// A line whose points come so much nearer to what was asked for than the other way round is a part of it.
constexpr double k_part = 2.5;
/// A line is nearer to what was asked for than to what is there already by at least this.
constexpr double k_nearer = 0.75;

std::vector<PxPoint> even(std::span<const PxPoint> line) {
  const auto points = curve::resample<PxPoint>(line, k_places);
  return points ? *points : std::vector<PxPoint>(line.begin(), line.end());
}

double distance_to(PxPoint p, std::span<const PxPoint> line) {
  double least = line.empty() ? std::numeric_limits<double>::infinity() : geometry::distance(p, line.front());
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const PxPoint way = line[i + 1] - line[i];
    const PxPoint to = p - line[i];
    const double length = way.x * way.x + way.y * way.y;
    const double share = length > 0 ? std::clamp((to.x * way.x + to.y * way.y) / length, 0.0, 1.0) : 0.0;
    least = std::min(least, geometry::distance(p, line[i] + way * share));
  }
  return least;
}

PxPoint middle_of(std::span<const PxPoint> line) {
  PxPoint sum;
  for (const PxPoint& p : line) sum = sum + p;
  return line.empty() ? sum : sum * (1.0 / static_cast<double>(line.size()));
}

/// "Too far up"; empty where the line lies right in the mean.
std::string which_way(PxPoint by, double within_px) {
  if (std::max(std::abs(by.x), std::abs(by.y)) < 0.7 * within_px) return {};
  if (std::abs(by.y) >= std::abs(by.x)) return by.y < 0 ? "Too far up" : "Too far down";
  return by.x < 0 ? "Too far to the left" : "Too far to the right";
}

}  // namespace

double mean_distance(std::span<const PxPoint> from, std::span<const PxPoint> to) {
  const auto points = even(from);
  if (points.empty() || to.empty()) return std::numeric_limits<double>::infinity();
  double sum = 0;
  for (const PxPoint& p : points) sum += distance_to(p, to);
  return sum / static_cast<double>(points.size());
}

LineJudgement judge_line(std::span<const PxPoint> drawn, const AskedLine& asked) {
  std::vector<PxPoint> mine(drawn.begin(), drawn.end());
  std::vector<PxPoint> line(asked.line.begin(), asked.line.end());
  if (asked.closed && !mine.empty() && !line.empty()) {
    mine.push_back(mine.front());
    line.push_back(line.front());
  }
  const double there = mean_distance(mine, line);
  const double back = mean_distance(line, mine);
  const std::string to = asked.closed ? "go all around along the dashed line" : "draw along the dashed line";
  if (!asked.from.empty() && mean_distance(mine, asked.from) * k_nearer < there)
    return {false, "It is already there: " + to};
  if (there <= asked.within_px && back <= asked.within_px) return {true, {}};
  if (back > asked.within_px && back > k_part * there) return {false, "That was a part of it: " + to + " to its end"};
  if (there > asked.within_px && there > k_part * back)
    return {false, "That went too far: stop where the dashed line ends"};
  const std::string way = which_way(middle_of(even(mine)) - middle_of(even(line)), asked.within_px);
  return {false, way.empty() ? "Not along it yet: " + to + ", slowly" : way + ": " + to};
}

}  // namespace penpose::app
