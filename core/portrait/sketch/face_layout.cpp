#include "core/portrait/sketch/face_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

#include "core/base/math.h"
#include "core/curve/polyline.h"
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

double off(double value, double mean, double spread) {
  const double d = (value - mean) / spread;
  return 0.5 * d * d;
}

bool is_around_eyes(FacePart part) {
  return part == FacePart::eye || part == FacePart::pupil || part == FacePart::fold || part == FacePart::brow;
}

/// Returns -log of how likely a mark is the habit's part, less a constant, on a face that is `scale` times as large as
/// usual around its eyes.
double cost_of(const FaceMark& mark, const PartHabit& habit, double scale) {
  const double by = is_around_eyes(habit.part) ? 1.0 : 1.0 / scale;
  const PxPoint at = mark.middle() * by;
  const PxPoint size = mark.size() * by;
  const double wide = base::log(std::max(size.x, k_least_size));
  const double high = base::log(std::max(size.y, k_least_size));
  const double x = habit.sides ? std::abs(at.x) : at.x;
  return habit.base + off(x, habit.x, habit.x_spread) + off(at.y, habit.y, habit.y_spread) +
         off(wide, base::log(habit.width), habit.width_spread) +
         off(high, base::log(habit.height), habit.height_spread);
}

bool within_face(const FaceMark& mark, double scale) {
  const PxPoint at = mark.middle() * (1.0 / scale);
  return std::abs(at.x) < k_face_half_width && at.y > -k_face_above && at.y < k_face_below;
}

/// Returns whether a closed line fills most of its box, as a window or a door does and an eye or a mouth does not.
bool is_box(const FaceMark& mark) {
  if (!mark.closed || mark.size().y < k_box_height * mark.size().x) return false;
  double twice = 0;
  for (std::size_t i = 0; i < mark.points.size(); ++i) {
    const PxPoint& a = mark.points[i];
    const PxPoint& b = mark.points[(i + 1) % mark.points.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return 0.5 * std::abs(twice) > k_box_filled * mark.size().x * mark.size().y;
}

/// Labels a mark with the likeliest part that is none of `without`.
void label(FaceMark& mark, double scale, std::initializer_list<FacePart> without = {}) {
  mark.part = FacePart::unknown;
  mark.cost = within_face(mark, scale) ? k_unknown_cost : k_around_cost;
  if (!within_face(mark, scale)) mark.part = FacePart::around;
  // A line that runs to and fro is no border of anything; brows and dots are filled so.
  const bool tangled = mark.length > k_tangled * (mark.size().x + mark.size().y) || mark.turning > k_scribbled;
  const bool box = !tangled && is_box(mark);
  for (const PartHabit& habit : part_habits()) {
    if (std::find(without.begin(), without.end(), habit.part) != without.end()) continue;
    if (tangled && habit.part != FacePart::brow && habit.part != FacePart::pupil) continue;
    if (box && (habit.part == FacePart::eye || habit.part == FacePart::pupil || habit.part == FacePart::mouth))
      continue;
    if (habit.form != LineForm::any && (habit.form == LineForm::closed) != mark.closed) continue;
    const double cost = cost_of(mark, habit, scale);
    if (cost >= mark.cost) continue;
    mark.cost = cost;
    mark.part = habit.part;
  }
  mark.right = mark.middle().x > 0;
}

bool is_straight(const FaceMark& mark) {
  return geometry::distance(mark.points.front(), mark.points.back()) > k_straight * mark.length;
}

/// Labels lines well within the outline of the head as something else than an outline, and not as an unwanted part.
void keep_one_outline(std::vector<FaceMark>& marks, double scale, FacePart unwanted) {
  const FaceMark* head = nullptr;
  for (const FaceMark& mark : marks) {
    if (mark.part == FacePart::outline && (head == nullptr || mark.size().y > head->size().y)) head = &mark;
  }
  if (head == nullptr) return;
  const PxPoint low = head->low + PxPoint{1, 1} * k_within_outline,
                high = head->high - PxPoint{1, 1} * k_within_outline;
  for (FaceMark& mark : marks) {
    const bool within = mark.low.x > low.x && mark.low.y > low.y && mark.high.x < high.x && mark.high.y < high.y;
    if (mark.part == FacePart::outline && within) label(mark, scale, {FacePart::outline, unwanted});
  }
}

/// Labels what lies outside of the head as something around it.
void leave_what_is_outside(std::vector<FaceMark>& marks) {
  const FaceMark* head = nullptr;
  for (const FaceMark& mark : marks) {
    const bool around_eyes = mark.low.x < -0.5 && mark.high.x > 0.5 && mark.low.y < 0 && mark.high.y > 0;
    if (mark.part == FacePart::outline && mark.closed && around_eyes &&
        (head == nullptr || mark.size().y > head->size().y))
      head = &mark;
  }
  if (head == nullptr) return;
  const PxPoint low = head->low, high = head->high;
  for (FaceMark& mark : marks) {
    const PxPoint at = mark.middle();
    if (at.x > low.x && at.y > low.y && at.x < high.x && at.y < high.y) continue;
    mark.part = FacePart::around;
    mark.cost = k_outside_cost;
  }
}

/// Drops construction lines: a straight line that is longer than the rest of the mouth only marks its place.
void drop_construction_line(FaceLayout& layout) {
  double low = 1e300, high = -1e300;
  for (const FaceMark& mark : layout.marks) {
    if (mark.part != FacePart::mouth || is_straight(mark)) continue;
    low = std::min(low, mark.low.x);
    high = std::max(high, mark.high.x);
  }
  for (FaceMark& mark : layout.marks) {
    if (!(low < high)) break;
    const bool longer = mark.size().x > k_longer_than_mouth * (high - low);
    if (mark.part == FacePart::mouth && is_straight(mark) && longer) mark.part = FacePart::unknown;
  }
}

/// Labels the likeliest line as the mouth if no line has that label yet, because a face has a mouth.
void find_mouth(FaceLayout& layout) {
  FaceMark* best = nullptr;
  double least = k_unknown_cost;
  for (FaceMark& mark : layout.marks) {
    if (mark.part == FacePart::mouth) return;
    if (mark.part == FacePart::around) continue;
    for (const PartHabit& habit : part_habits()) {
      if (habit.part != FacePart::mouth || cost_of(mark, habit, layout.scale) >= least) continue;
      least = cost_of(mark, habit, layout.scale);
      best = &mark;
    }
  }
  if (best == nullptr) return;
  best->part = FacePart::mouth;
  best->cost = least;
}

/// Returns whether a mark is near enough to the mouth's first line to be of the same mouth.
bool is_of_mouth(const FaceMark& mark, const FaceMark& first) {
  const PxPoint d = mark.middle() - first.middle();
  const PxPoint reach = (first.size() + mark.size()) * 0.5 + PxPoint{k_mouth_reach, k_mouth_reach};
  return std::abs(d.x) < reach.x && std::abs(d.y) < reach.y;
}

/// Returns whether a mark lies within the box of a larger one.
bool is_upon(const FaceMark& mark, const FaceMark& larger) {
  const PxPoint at = mark.middle();
  return at.x > larger.low.x && at.x < larger.high.x && at.y > larger.low.y && at.y < larger.high.y &&
         mark.size().x < larger.size().x;
}

double weight_of(const FaceMark& mark) { return std::sqrt(std::max(k_least_size, mark.length)); }

/// Keeps one mouth and the lines near it: the one with which all lines that could be a mouth are likeliest, since those
/// that are not of it are something else, such as a large nose above it.
void keep_one_mouth(FaceLayout& layout) {
  drop_construction_line(layout);
  std::vector<FaceMark> others;
  for (const FaceMark& mark : layout.marks) {
    others.push_back(mark);
    if (mark.part == FacePart::mouth) label(others.back(), layout.scale, {FacePart::mouth});
  }
  keep_one_outline(others, layout.scale, FacePart::mouth);
  // What lies on a nose is one of its nostrils.
  for (const FaceMark& nose : layout.marks) {
    for (std::size_t i = 0; i < others.size() && nose.part == FacePart::nose; ++i) {
      if (layout.marks[i].part != FacePart::mouth || others[i].cost <= k_nostril_cost || !is_upon(others[i], nose))
        continue;
      others[i].part = FacePart::nose;
      others[i].cost = k_nostril_cost;
    }
  }
  const FaceMark* best = nullptr;
  double least = 0;
  for (const FaceMark& first : layout.marks) {
    if (first.part != FacePart::mouth) continue;
    double sum = 0;
    for (std::size_t i = 0; i < others.size(); ++i) {
      const FaceMark& mark = layout.marks[i];
      if (mark.part == FacePart::mouth)
        sum += weight_of(mark) * (is_of_mouth(mark, first) ? mark.cost : others[i].cost);
    }
    if (best != nullptr && sum >= least) continue;
    best = &first;
    least = sum;
  }
  if (best == nullptr) return;
  const FaceMark first = *best;
  for (std::size_t i = 0; i < others.size(); ++i) {
    if (layout.marks[i].part == FacePart::mouth && !is_of_mouth(layout.marks[i], first)) layout.marks[i] = others[i];
  }
}

bool is_of_eye(const FaceMark& mark) { return mark.part == FacePart::eye || mark.part == FacePart::pupil; }

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

/// A pupil that touches no border of its eye costs more if the eye has borders.
void charge_for_stray_pupils(FaceLayout& layout) {
  for (FaceMark& pupil : layout.marks) {
    if (pupil.part != FacePart::pupil) continue;
    bool bordered = false, touches = false;
    for (const FaceMark& eye : layout.marks) {
      if (eye.part != FacePart::eye || eye.right != pupil.right) continue;
      bordered = true;
      touches = touches || (pupil.low.y < eye.high.y + k_touch && pupil.high.y > eye.low.y - k_touch);
    }
    if (bordered && !touches) pupil.cost += k_stray_pupil_cost;
  }
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
  leave_what_is_outside(layout.marks);
  charge_for_stray_pupils(layout);
  keep_one_outline(layout.marks, scale, FacePart::outline);
  if (whole_face) find_mouth(layout);
  keep_one_mouth(layout);
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
