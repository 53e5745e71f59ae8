#include "core/portrait/sketch/hatching.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/curve/polyline.h"
#include "core/portrait/sketch/habits.h"
#include "core/portrait/sketch/pen_strokes.h"

namespace penpose::portrait {
namespace {

using geometry::PxPoint;

/// A straight and short stroke.
struct Hatch {
  std::size_t line = 0;
  PxPoint middle{0, 0}, along{0, 0};  ///< along: of length 1
  double length = 0;
};

double diagonal_of(std::span<const std::vector<PxPoint>> lines) {
  PxPoint low{1e300, 1e300}, high{-1e300, -1e300};
  for (const auto& line : lines) {
    for (const PxPoint& p : line) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  return geometry::distance(low, high);
}

std::vector<Hatch> hatches_of(std::span<const std::vector<PxPoint>> lines) {
  const double longest = k_longest_hatch * diagonal_of(lines);
  std::vector<Hatch> hatches;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double length = curve::arc_length<PxPoint>(lines[i]);
    const PxPoint chord = lines[i].back() - lines[i].front();
    const double reach = geometry::distance(lines[i].back(), lines[i].front());
    if (!(length > 0) || length > longest || reach < k_straight_hatch * length) continue;
    hatches.push_back({i, (lines[i].front() + lines[i].back()) * 0.5, chord * (1 / reach), length});
  }
  return hatches;
}

bool beside(const Hatch& a, const Hatch& b) {
  const double longer = std::max(a.length, b.length);
  return longer < k_unlike_hatches * std::min(a.length, b.length) &&
         geometry::distance(a.middle, b.middle) < k_hatches_apart * longer &&
         std::abs(geometry::dot(a.along, b.along)) > k_parallel_hatches;
}

/// Numbers the groups of hatches that lie beside each other, each by its first one.
std::vector<std::size_t> groups_of(const std::vector<Hatch>& hatches) {
  std::vector<std::size_t> group(hatches.size());
  std::iota(group.begin(), group.end(), std::size_t{0});
  for (std::size_t a = 0; a < hatches.size(); ++a) {
    for (std::size_t b = a + 1; b < hatches.size(); ++b) {
      if (group[a] == group[b] || !beside(hatches[a], hatches[b])) continue;
      const std::size_t from = std::max(group[a], group[b]), to = std::min(group[a], group[b]);
      std::replace(group.begin(), group.end(), from, to);
    }
  }
  return group;
}

/// Returns the middles of hatches in order between the two that are farthest from each other; nothing if they do not
/// lie in a row.
std::vector<PxPoint> row_of(std::vector<Hatch> hatches) {
  const Hatch* first = nullptr;
  const Hatch* last = nullptr;
  double farthest = 0;
  for (const Hatch& a : hatches) {
    for (const Hatch& b : hatches) {
      const double distance = geometry::distance(a.middle, b.middle);
      if (distance <= farthest) continue;
      farthest = distance;
      first = &a;
      last = &b;
    }
  }
  std::vector<double> lengths;
  for (const Hatch& one : hatches) lengths.push_back(one.length);
  std::stable_sort(lengths.begin(), lengths.end());
  if (first == nullptr || farthest < k_row_of_hatches * lengths[lengths.size() / 2]) return {};
  const PxPoint from = first->middle, along = last->middle - first->middle;
  std::stable_sort(hatches.begin(), hatches.end(), [&](const Hatch& a, const Hatch& b) {
    return geometry::dot(a.middle - from, along) < geometry::dot(b.middle - from, along);
  });
  std::vector<PxPoint> row;
  for (const Hatch& one : hatches) row.push_back(one.middle);
  return row;
}

}  // namespace

JoinedLines join_hatching(std::span<const std::vector<PxPoint>> drawn) {
  std::vector<std::vector<PxPoint>> lines;
  for (const auto& line : drawn) lines.push_back(middle_of_stroke(line));
  const std::vector<Hatch> hatches = hatches_of(lines);
  const std::vector<std::size_t> group = groups_of(hatches);
  constexpr std::size_t k_alone = static_cast<std::size_t>(-1);
  std::vector<std::size_t> row_of_line(lines.size(), k_alone);
  std::vector<std::vector<PxPoint>> rows;
  for (std::size_t g = 0; g < hatches.size(); ++g) {
    std::vector<Hatch> members;
    for (std::size_t h = g; h < hatches.size(); ++h) {
      if (group[h] == g) members.push_back(hatches[h]);
    }
    if (members.size() < k_fewest_hatches) continue;
    std::vector<PxPoint> row = row_of(members);
    if (row.empty()) continue;
    for (const Hatch& one : members) row_of_line[one.line] = rows.size();
    rows.push_back(std::move(row));
  }
  JoinedLines joined;
  std::vector<std::size_t> number(rows.size(), k_alone);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::size_t row = row_of_line[i];
    if (row == k_alone || number[row] == k_alone) {
      if (row != k_alone) number[row] = joined.lines.size();
      joined.joined_in.push_back(joined.lines.size());
      joined.lines.push_back(row == k_alone ? lines[i] : rows[row]);
    } else {
      joined.joined_in.push_back(number[row]);
    }
  }
  return joined;
}

}  // namespace penpose::portrait
