#include "tests/judges/drawing/faces/sheet.h"

#include <algorithm>
#include <cmath>

#include "core/base/math.h"

namespace penpose::judges::drawn {
namespace {

constexpr std::size_t k_points = 40;
/// How far beside the first line a second one lies, px.
constexpr double k_beside = 2.5;

/// Points of a Catmull-Rom spline; of a closed one the first is the last again.
std::vector<PxPoint> smooth(const std::vector<PxPoint>& through, bool closed) {
  constexpr int k_steps = 12;
  const auto count = static_cast<std::ptrdiff_t>(through.size());
  const auto at = [&](std::ptrdiff_t i) {
    if (closed) return through[static_cast<std::size_t>((i + count) % count)];
    return through[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, count - 1))];
  };
  std::vector<PxPoint> out;
  const std::ptrdiff_t pieces = closed ? count : count - 1;
  for (std::ptrdiff_t i = 0; i < pieces; ++i) {
    const PxPoint a = at(i), b = at(i + 1), way_a = (b - at(i - 1)) * 0.5, way_b = (at(i + 2) - a) * 0.5;
    for (int k = 0; k < k_steps; ++k) {
      const double t = static_cast<double>(k) / k_steps, u = 1 - t;
      out.push_back(a * (u * u * (1 + 2 * t)) + way_a * (u * u * t) + b * (t * t * (3 - 2 * t)) + way_b * (-t * t * u));
    }
  }
  out.push_back(at(pieces));
  return out;
}

}  // namespace

std::vector<DrawnStroke> strokes_of(const Stroke& stroke, std::span<const PxPoint> meant, std::size_t number,
                                    tests::Random& random) {
  const auto drawn = [&] {
    const auto seed = static_cast<std::uint64_t>(random.index(1U << 30U));
    auto points = drawn_by(stroke.hand, meant, seed, k_points);
    if (random(0, 1) < 0.5) std::reverse(points.begin(), points.end());
    return points;
  };
  const double how = random(0, 1);
  std::vector<DrawnStroke> out{{drawn(), number}};
  if (how < stroke.doubled) {
    auto again = drawn();
    const PxPoint beside{random(-k_beside, k_beside), random(-k_beside, k_beside)};
    for (PxPoint& p : again) p = p + beside;
    out.push_back({std::move(again), number});
  } else if (how < stroke.doubled + stroke.in_pieces) {
    auto& first = out.front().points;
    const auto cut = static_cast<std::ptrdiff_t>(k_points / 3 + random.index(k_points / 3));
    const auto gap = static_cast<std::ptrdiff_t>(random.index(3));
    out.push_back({portrait::DrawnLine(first.begin() + cut + gap, first.end()), number});
    first.erase(first.begin() + cut + 1, first.end());
  }
  return out;
}

void Sheet::draw(std::span<const PxPoint> meant) {
  for (DrawnStroke& one : strokes_of(stroke_, meant, 0, random_)) lines_.push_back(std::move(one.points));
}

void Sheet::line(const std::vector<PxPoint>& through) { draw(smooth(through, false)); }
void Sheet::loop(const std::vector<PxPoint>& through) { draw(smooth(through, true)); }
void Sheet::corners(const std::vector<PxPoint>& points) { draw(points); }
void Sheet::oval(PxPoint middle, double half_width, double half_height) {
  arc(middle, half_width, half_height, 90, 450);
}
void Sheet::arc(PxPoint middle, double half_width, double half_height, double from_degrees, double to_degrees) {
  constexpr int k_steps = 48;
  std::vector<PxPoint> points;
  for (int i = 0; i <= k_steps; ++i) {
    const double angle = base::radians(from_degrees + (to_degrees - from_degrees) * i / k_steps);
    points.push_back(middle + PxPoint{half_width * base::cos(angle), -half_height * base::sin(angle)});
  }
  draw(points);
}

}  // namespace penpose::judges::drawn
