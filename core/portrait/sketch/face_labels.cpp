#include "core/portrait/sketch/face_labels.h"

#include <algorithm>
#include <cmath>

#include "core/base/math.h"
#include "core/portrait/sketch/habits.h"

namespace penpose::portrait {
namespace {

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

}  // namespace

bool is_of_eye(const FaceMark& mark) { return mark.part == FacePart::eye || mark.part == FacePart::pupil; }

double weight_of(const FaceMark& mark) { return std::sqrt(std::max(k_least_size, mark.length)); }

void label(FaceMark& mark, double scale, std::initializer_list<FacePart> without) {
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

namespace {

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

}  // namespace

void settle_labels(FaceLayout& layout, bool whole_face) {
  leave_what_is_outside(layout.marks);
  charge_for_stray_pupils(layout);
  keep_one_outline(layout.marks, layout.scale, FacePart::outline);
  if (whole_face) find_mouth(layout);
  keep_one_mouth(layout);
}

}  // namespace penpose::portrait
