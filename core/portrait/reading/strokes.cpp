#include "core/portrait/reading/strokes.h"

#include <algorithm>

#include "core/curve/polyline.h"

namespace penpose::portrait {
namespace {

using geometry::PxPoint;
using Line = std::vector<PxPoint>;

/// Ends meet that are nearer to each other than this share of the length.
constexpr double k_meet = 0.08;
/// Points that a line around something is cut with.
constexpr std::size_t k_around = 64;

double middle_height(const Line& line) {
  double sum = 0;
  for (const PxPoint& p : line) sum += p.y;
  return sum / static_cast<double>(line.size());
}

/// Its halves, the upper one first; none for a line that is not drawn around.
std::vector<Line> halves_of(const Line& line) {
  const double length = curve::arc_length<PxPoint>(line);
  if (geometry::distance(line.front(), line.back()) > k_meet * length) return {};
  auto around = curve::resample<PxPoint>(line, k_around);
  if (!around) return {};
  around->pop_back();  // where it began
  const auto before = [](const PxPoint& a, const PxPoint& b) { return a.x < b.x; };
  std::rotate(around->begin(), std::min_element(around->begin(), around->end(), before), around->end());
  const auto right = std::max_element(around->begin(), around->end(), before);
  if (right - around->begin() < 3 || around->end() - right < 3) return {};
  Line one(around->begin(), right + 1), other(right, around->end());
  other.push_back(around->front());
  if (middle_height(one) > middle_height(other)) std::swap(one, other);
  return {std::move(one), std::move(other)};
}

}  // namespace

std::vector<Stroke> strokes_of(std::span<const Line> lines, std::span<const std::optional<std::size_t>> given) {
  std::vector<Stroke> out;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    auto halves = i < given.size() && given[i] ? std::vector<Line>{} : halves_of(lines[i]);
    if (halves.empty()) {
      out.push_back({lines[i], {i}, false});
    } else {
      out.push_back({std::move(halves[0]), {i}, false});
      out.push_back({std::move(halves[1]), {i}, true});
    }
  }
  return out;
}

}  // namespace penpose::portrait
