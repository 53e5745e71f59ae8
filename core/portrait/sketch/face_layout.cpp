#include "core/portrait/sketch/face_layout.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/math.h"
#include "core/curve/polyline.h"
#include "core/portrait/sketch/face_labels.h"
#include "core/portrait/sketch/habits.h"
#include "core/portrait/sketch/hatching.h"

namespace penpose::portrait {
namespace {

constexpr std::size_t k_mark_points = 33;

struct Box {
  PxPoint low{1e300, 1e300}, high{-1e300, -1e300};
  void add(const PxPoint& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
};

/// The mean angle between neighbouring pieces of an even line, radians.
double turning_of(const std::vector<PxPoint>& even) {
  double sum = 0, count = 0;
  for (std::size_t i = 1; i + 1 < even.size(); ++i) {
    const PxPoint a = even[i] - even[i - 1], b = even[i + 1] - even[i];
    if (!(geometry::dot(a, a) > 0) || !(geometry::dot(b, b) > 0)) continue;
    sum += std::abs(base::atan2(a.x * b.y - a.y * b.x, geometry::dot(a, b)));
    count += 1;
  }
  return count > 0 ? sum / count : 0;
}

/// Resamples each line evenly and measures its box.
std::vector<FaceMark> marks_of(std::span<const std::vector<PxPoint>> lines) {
  std::vector<FaceMark> marks;
  for (const std::vector<PxPoint>& line : lines) {
    FaceMark mark;
    auto even = curve::resample<PxPoint>(line, k_mark_points);
    mark.points = even ? std::move(*even) : std::vector<PxPoint>(k_mark_points, line.front());
    const double length = curve::arc_length<PxPoint>(line);
    mark.closed = geometry::distance(line.front(), line.back()) <= k_ends_meet * length;
    mark.turning = turning_of(mark.points);
    Box box;
    for (const PxPoint& p : mark.points) box.add(p);
    mark.low = box.low;
    mark.high = box.high;
    marks.push_back(std::move(mark));
  }
  return marks;
}

/// Returns how much the sizes of two marks differ: the sum of the differences of their logarithms.
double unlike(const FaceMark& a, const FaceMark& b) {
  const auto ratio = [](double x, double y) {
    return std::abs(base::log(std::max(x, k_least_size) / std::max(y, k_least_size)));
  };
  return ratio(a.size().x, b.size().x) + ratio(a.size().y, b.size().y);
}

/// Returns the least `unlike` between a mark of the left eye and one of the right eye.
double unlike_eyes(const FaceLayout& layout) {
  double least = k_most_unlike;
  for (const FaceMark& a : layout.marks) {
    if (!is_of_eye(a) || a.right) continue;
    for (const FaceMark& b : layout.marks) {
      if (is_of_eye(b) && b.right) least = std::min(least, unlike(a, b));
    }
  }
  return least;
}

FaceLayout laid(const std::vector<FaceMark>& marks, PxPoint middle, PxPoint along, double scale,
                bool whole_face = true) {
  FaceLayout layout;
  layout.scale = scale;
  layout.middle = middle;
  layout.along = along;
  double sum = 0;
  double count = 0;
  for (const FaceMark& mark : marks) {
    FaceMark one = mark;
    Box box;
    for (PxPoint& p : one.points) {
      p = layout.in_frame(p);
      box.add(p);
    }
    one.low = box.low;
    one.high = box.high;
    one.length = curve::arc_length<PxPoint>(one.points);
    label(one, scale);
    layout.marks.push_back(std::move(one));
  }
  settle_labels(layout, whole_face);
  std::array<bool, 2> eye{false, false}, brow{false, false};
  bool mouth = false;
  for (const FaceMark& mark : layout.marks) {
    const std::size_t side = mark.right ? 1 : 0;
    if (mark.part == FacePart::eye || mark.part == FacePart::pupil) eye[side] = true;
    if (mark.part == FacePart::brow) brow[side] = true;
    if (mark.part == FacePart::mouth) mouth = true;
    sum += weight_of(mark) * mark.cost;
    count += weight_of(mark);
  }
  layout.cost = (count > 0 ? sum / count : k_unknown_cost) + k_unlike_cost * unlike_eyes(layout);
  if (!mouth || !eye[0] || !eye[1]) layout.cost += k_unknown_cost;
  if (brow[0] != brow[1]) layout.cost += k_lone_brow_cost;
  if (!brow[0] && !brow[1]) layout.cost += k_no_brows_cost;
  layout.cost += k_scale_cost * base::log(scale) * base::log(scale);
  return layout;
}

/// Returns whether two marks can be the eyes of a face: they have similar sizes and lie beside each other.
bool may_be_eyes(const FaceMark& a, const FaceMark& b) {
  const PxPoint d = b.middle() - a.middle();
  const double one = std::max(a.size().x, a.size().y);
  const double other = std::max(b.size().x, b.size().y);
  const double large = std::max(one, other);
  // A dot may stand beside a dot, or beside a line that winks.
  const bool dots = std::min(one, other) <= k_smallest_eye * d.x && large < k_largest_wink * d.x;
  return d.x > 0 && std::abs(d.y) < k_most_roll * d.x && large < k_largest_eye * d.x &&
         (dots || std::min(one, other) > k_least_alike * large);
}

/// Returns whether a face without brows has neither clear eyes nor a clear mouth, as many things look.
bool is_doubtful(const FaceLayout& layout) {
  std::array<double, 2> eyes{k_unknown_cost, k_unknown_cost};
  double mouth = k_unknown_cost;
  for (const FaceMark& mark : layout.marks) {
    if (mark.part == FacePart::brow) return false;
    double& least = mark.part == FacePart::mouth ? mouth : eyes[mark.right ? 1 : 0];
    if (mark.part == FacePart::mouth || is_of_eye(mark)) least = std::min(least, mark.cost);
  }
  return 0.5 * (eyes[0] + eyes[1]) + mouth > k_most_doubtful;
}

/// Fits the frame to all lines of the eyes that have a counterpart in the other eye.
FaceLayout refined(const std::vector<FaceMark>& marks, const FaceLayout& found) {
  PxPoint left{0, 0}, right{0, 0};
  double weight = 0;
  for (const FaceMark& a : found.marks) {
    if (!is_of_eye(a) || a.right) continue;
    const FaceMark* best = nullptr;
    double least = k_counterpart;
    for (const FaceMark& b : found.marks) {
      if (!is_of_eye(b) || !b.right) continue;
      const PxPoint d{a.middle().x + b.middle().x, a.middle().y - b.middle().y};
      const double off = unlike(a, b) + k_counterpart_off * (std::abs(d.x) + std::abs(d.y));
      if (off >= least) continue;
      least = off;
      best = &b;
    }
    if (best == nullptr) continue;
    const double own = a.size().x + best->size().x;
    left = left + a.middle() * own;
    right = right + best->middle() * own;
    weight += own;
  }
  if (!(weight > 0)) return found;
  const PxPoint l = found.on_sheet(left * (1 / weight));
  const PxPoint r = found.on_sheet(right * (1 / weight));
  FaceLayout again = laid(marks, (l + r) * 0.5, r - l, found.scale);
  return again.cost < found.cost + k_refined_gain ? again : found;
}

}  // namespace

PxPoint FaceLayout::in_frame(const PxPoint& p) const {
  const PxPoint d = p - middle;
  const double squared = geometry::dot(along, along);
  return {geometry::dot(d, along) / squared, (along.x * d.y - along.y * d.x) / squared};
}

PxPoint FaceLayout::on_sheet(const PxPoint& p) const { return middle + along * p.x + PxPoint{-along.y, along.x} * p.y; }

FaceLayout lay_out(std::span<const std::vector<PxPoint>> lines, PxPoint middle, PxPoint along) {
  JoinedLines joined = join_hatching(lines);
  FaceLayout layout = laid(marks_of(joined.lines), middle, along, 1.0, false);
  layout.mark_of_line = std::move(joined.joined_in);
  return layout;
}

std::optional<FaceLayout> find_face(std::span<const std::vector<PxPoint>> lines, const EyesCost& eyes_cost) {
  JoinedLines joined = join_hatching(lines);
  const std::vector<FaceMark> marks = marks_of(joined.lines);
  struct Pair {
    FaceLayout layout;
    double of_eyes = 0;
    [[nodiscard]] double cost() const { return layout.cost + of_eyes; }
  };
  std::vector<Pair> pairs;
  for (std::size_t a = 0; a < marks.size(); ++a) {
    for (std::size_t b = 0; b < marks.size(); ++b) {
      if (!may_be_eyes(marks[a], marks[b])) continue;
      const double of_eyes = eyes_cost ? eyes_cost(a, b) : 0.0;
      const PxPoint left = marks[a].middle(), right = marks[b].middle();
      if (of_eyes < k_unknown_cost) pairs.push_back({laid(marks, (left + right) * 0.5, right - left, 1.0), of_eyes});
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.cost() < b.cost(); });
  if (pairs.size() > k_most_scaled) pairs.resize(k_most_scaled);
  std::optional<FaceLayout> best;
  double least = 0;
  for (Pair& pair : pairs) {
    for (const double scale : k_scales) {
      FaceLayout one = laid(marks, pair.layout.middle, pair.layout.along, scale);
      if (best && one.cost + pair.of_eyes >= least) continue;
      least = one.cost + pair.of_eyes;
      best = std::move(one);
    }
  }
  if (!best) return best;
  if (!eyes_cost) best = refined(marks, *best);
  if (is_doubtful(*best)) return std::nullopt;
  const bool has_mouth = std::any_of(best->marks.begin(), best->marks.end(), [](const FaceMark& mark) {
    return mark.part == FacePart::mouth && mark.cost < k_most_mouth_cost;
  });
  if (!has_mouth || best->cost >= k_unknown_cost) return std::nullopt;
  best->mark_of_line = std::move(joined.joined_in);
  return best;
}

const char* name_of(FacePart part) {
  constexpr std::array<const char*, 11> k_names{"eye",    "pupil", "fold",    "brow",   "nose",   "mouth",
                                                "corner", "cheek", "outline", "around", "unknown"};
  return k_names[static_cast<std::size_t>(part)];
}

}  // namespace penpose::portrait
