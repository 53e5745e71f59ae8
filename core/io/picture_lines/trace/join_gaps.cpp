#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/io/picture_lines/trace/internal/strokes.h"

namespace penpose::io {
namespace {

using geometry::PxPoint;

constexpr double k_least_gap_px = 4;    ///< that is joined however thin the lines are
constexpr double k_most_gap_px = 40;    ///< that is joined where other ink covers it
constexpr double k_covered = 0.7;       ///< of a gap
constexpr double k_aims = 0.87;         ///< cosine of how far an end may look past the other, 30 degrees
constexpr std::ptrdiff_t k_chord = 10;  ///< points that give the direction of an end

/// One end of a stroke.
struct Tip {
  std::size_t stroke = 0;
  bool at_back = false;
  PxPoint place;
  PxPoint outward;  ///< of length one
};

/// What of a stroke's end may be bent by the ink beside it.
std::ptrdiff_t bent_points(const TracedStroke& stroke) {
  const auto count = static_cast<std::ptrdiff_t>(stroke.points.size());
  return std::min(static_cast<std::ptrdiff_t>(2 * stroke.radius) + 1, (count - 1) / 3);
}

Tip tip_of(const std::vector<TracedStroke>& strokes, std::size_t number, bool at_back) {
  const auto& points = strokes[number].points;
  const auto count = static_cast<std::ptrdiff_t>(points.size());
  const auto from_end = [&](std::ptrdiff_t i) { return points[static_cast<std::size_t>(at_back ? count - 1 - i : i)]; };
  const std::ptrdiff_t bent = bent_points(strokes[number]);
  const PxPoint way = from_end(bent) - from_end(std::min(bent + k_chord, count - 1));
  const double length = std::sqrt(geometry::dot(way, way));
  const PxPoint outward = length > 0 ? way * (1 / length) : PxPoint{};
  return {number, at_back, from_end(bent) + outward * geometry::distance(from_end(0), from_end(bent)), outward};
}

/// Two ends that may be one line, and how far they are apart.
struct Gap {
  double width = 0;
  std::size_t first = 0;  ///< tip
  std::size_t second = 0;
};

class GapJoiner {
 public:
  GapJoiner(std::vector<TracedStroke>& strokes, const Ink& ink) : strokes_(strokes), ink_(ink) {}

  void join() {
    for (std::size_t i = 0; i < strokes_.size(); ++i) {
      if (strokes_[i].closed || strokes_[i].points.size() < 2) continue;
      for (const bool at_back : {false, true}) tips_.push_back(tip_of(strokes_, i, at_back));
    }
    std::vector<Gap> gaps = find();
    std::stable_sort(gaps.begin(), gaps.end(), [](const Gap& a, const Gap& b) { return a.width < b.width; });
    std::vector<bool> taken(tips_.size());
    for (const Gap& gap : gaps) {
      if (taken[gap.first] || taken[gap.second]) continue;
      taken[gap.first] = taken[gap.second] = true;
      partners_[gap.first] = gap.second;
      partners_[gap.second] = gap.first;
    }
    link();
  }

 private:
  std::vector<Gap> find() const {
    // Tips by squares as wide as the widest gap.
    std::map<std::pair<int, int>, std::vector<std::size_t>> squares;
    const auto square_of = [](PxPoint p) {
      return std::pair(static_cast<int>(p.x / k_most_gap_px), static_cast<int>(p.y / k_most_gap_px));
    };
    for (std::size_t i = 0; i < tips_.size(); ++i) squares[square_of(tips_[i].place)].push_back(i);
    std::vector<Gap> gaps;
    for (std::size_t i = 0; i < tips_.size(); ++i) {
      const auto [x, y] = square_of(tips_[i].place);
      for (int row = y - 1; row <= y + 1; ++row) {
        for (int column = x - 1; column <= x + 1; ++column) {
          const auto found = squares.find({column, row});
          if (found == squares.end()) continue;
          for (const std::size_t k : found->second) {
            if (k > i && is_gap(tips_[i], tips_[k]))
              gaps.push_back({geometry::distance(tips_[i].place, tips_[k].place), i, k});
          }
        }
      }
    }
    return gaps;
  }

  [[nodiscard]] bool is_gap(const Tip& a, const Tip& b) const {
    const PxPoint way = b.place - a.place;
    const double width = std::sqrt(geometry::dot(way, way));
    if (width > k_most_gap_px || !(width > 0)) return false;
    const TracedStroke& one = strokes_[a.stroke];
    const TracedStroke& other = strokes_[b.stroke];
    // The ends of one stroke are a gap where it goes nearly round.
    if (a.stroke == b.stroke && one.points.size() < static_cast<std::size_t>(4 * width)) return false;
    const double aims = std::min(geometry::dot(a.outward, way), -geometry::dot(b.outward, way)) / width;
    // What is a px or two apart says little of a direction.
    if (width <= 2.5 ? aims < 0 || -geometry::dot(a.outward, b.outward) < k_aims : aims < k_aims) return false;
    return width <= std::max(k_least_gap_px, 2 * (one.radius + other.radius)) || is_covered(a.place, way, width);
  }

  [[nodiscard]] bool is_covered(PxPoint from, PxPoint way, double width) const {
    const int steps = static_cast<int>(std::ceil(width));
    int covered = 0;
    for (int i = 0; i <= steps; ++i) {
      const PxPoint p = from + way * (static_cast<double>(i) / steps);
      const int x = static_cast<int>(p.x);
      const int y = static_cast<int>(p.y);
      covered += ink_.hue.contains(x, y) && ink_.hue[ink_.hue.index(x, y)] != 0;
    }
    return covered >= k_covered * (steps + 1);
  }

  void link() {
    std::vector<bool> used(strokes_.size());
    std::vector<TracedStroke> linked;
    const auto tip_at = [&](std::size_t tip) -> const Tip& { return tips_[tip]; };
    const auto walk = [&](std::size_t tip) {
      TracedStroke all;
      double length = 0;
      while (!used[tip_at(tip).stroke]) {
        const TracedStroke& one = strokes_[tip_at(tip).stroke];
        used[tip_at(tip).stroke] = true;
        const bool reversed = tip_at(tip).at_back;
        const auto count = static_cast<double>(one.points.size());
        all.radius = (all.radius * length + one.radius * count) / (length + count);
        length += count;
        // A stroke's two tips follow each other.
        const auto next = partners_.find(tip ^ 1U);
        const std::ptrdiff_t bent = bent_points(one);
        const std::ptrdiff_t first = partners_.contains(tip) ? bent : 0;
        const std::ptrdiff_t last = next == partners_.end() ? 0 : bent;
        if (reversed) all.points.insert(all.points.end(), one.points.rbegin() + first, one.points.rend() - last);
        if (!reversed) all.points.insert(all.points.end(), one.points.begin() + first, one.points.end() - last);
        if (next == partners_.end()) break;
        tip = next->second;
        if (used[tip_at(tip).stroke]) {
          all.closed = true;
          all.points.push_back(all.points.front());
        }
      }
      linked.push_back(std::move(all));
    };
    for (std::size_t tip = 0; tip < tips_.size(); ++tip) {
      if (!used[tips_[tip].stroke] && !partners_.contains(tip)) walk(tip);
    }
    for (std::size_t tip = 0; tip < tips_.size(); ++tip) {
      if (!used[tips_[tip].stroke]) walk(tip);
    }
    for (std::size_t i = 0; i < strokes_.size(); ++i) {
      if (strokes_[i].closed) linked.push_back(std::move(strokes_[i]));
    }
    strokes_ = std::move(linked);
  }

  std::vector<TracedStroke>& strokes_;
  const Ink& ink_;
  std::vector<Tip> tips_;
  std::map<std::size_t, std::size_t> partners_;
};

}  // namespace

void join_gaps(std::vector<TracedStroke>& strokes, const Ink& ink) { GapJoiner(strokes, ink).join(); }

}  // namespace penpose::io
