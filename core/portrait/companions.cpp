#include "core/portrait/companions.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace penpose::portrait {
namespace {

using geometry::PxPoint;

PxPoint middle_point(const std::vector<PxPoint>& line) { return line[line.size() / 2]; }

}  // namespace

std::vector<std::optional<std::size_t>> companions_of(std::span<const std::vector<PxPoint>> curves,
                                                      std::span<const Part> parts) {
  std::vector<std::optional<std::size_t>> out(curves.size());
  double middle = 0, eyes = 0;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (parts[c] != Part::eye) continue;
    middle += middle_point(curves[c]).x;
    eyes += 1.0;
  }
  if (eyes == 0.0) return out;
  middle /= eyes;
  /// The highest and the lowest of a part's curves on a side, by their middles.
  struct Ends {
    std::optional<std::size_t> high, low;
    std::size_t count = 0;
  };
  const auto ends_of = [&](Part part, std::optional<bool> right) {
    Ends ends;
    for (std::size_t c = 0; c < curves.size(); ++c) {
      if (parts[c] != part || (right && (middle_point(curves[c]).x > middle) != *right)) continue;
      ++ends.count;
      if (!ends.high || middle_point(curves[c]).y < middle_point(curves[*ends.high]).y) ends.high = c;
      if (!ends.low || middle_point(curves[c]).y > middle_point(curves[*ends.low]).y) ends.low = c;
    }
    return ends;
  };
  for (const Part part : {Part::brow, Part::eye}) {
    const std::array<Ends, 2> sides = {ends_of(part, false), ends_of(part, true)};
    for (const std::size_t side : {0, 1}) {
      if (sides[side].low && sides[side].low != sides[side].high) out[*sides[side].low] = sides[side].high;
      if (sides[side].high) out[*sides[side].high] = sides[1 - side].high;
    }
  }
  const Ends lips = ends_of(Part::mouth, std::nullopt);
  if (lips.count > 2) {
    out[*lips.high] = lips.low;
    out[*lips.low] = lips.high;
  }
  // A part of the outline is drawn where all of it is.
  std::optional<std::size_t> widest;
  const auto width = [&](std::size_t c) { return std::abs(curves[c].back().x - curves[c].front().x); };
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (parts[c] == Part::jaw && (!widest || width(c) > width(*widest))) widest = c;
  }
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (parts[c] == Part::jaw && c != *widest) out[c] = widest;
  }
  return out;
}

std::optional<std::array<std::size_t, 2>> parting_of(std::span<const std::vector<PxPoint>> curves,
                                                     std::span<const Part> parts) {
  std::vector<std::size_t> lips;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (parts[c] == Part::mouth) lips.push_back(c);
  }
  if (lips.size() != 4) return std::nullopt;
  std::stable_sort(lips.begin(), lips.end(),
                   [&](std::size_t a, std::size_t b) { return middle_point(curves[a]).y < middle_point(curves[b]).y; });
  return std::array<std::size_t, 2>{lips[1], lips[2]};
}

}  // namespace penpose::portrait
