#include "core/portrait/sketch/measures.h"

#include <algorithm>
#include <cmath>

#include "core/portrait/sketch/bend.h"
#include "core/portrait/sketch/habits.h"

namespace penpose::portrait {
namespace {

Marks marks_of(const FaceLayout& layout, FacePart part, std::optional<std::size_t> side) {
  Marks out;
  for (const FaceMark& mark : layout.marks) {
    if (mark.part == part && (!side || mark.right == (*side == 1))) out.push_back(&mark);
  }
  return out;
}

/// Adds the heights at which a mark crosses the upright line at x. One that is closed runs on from its end to its
/// start.
void add_crossings(const FaceMark& mark, double x, std::vector<double>& out) {
  const std::size_t n = mark.points.size();
  for (std::size_t i = 0; i + (mark.closed ? 0 : 1) < n; ++i) {
    const PxPoint& a = mark.points[i];
    const PxPoint& b = mark.points[(i + 1) % n];
    if ((a.x <= x) == (b.x <= x)) continue;
    out.push_back(a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x));
  }
}

/// Returns the heights of the lines that cross the upright line at x, ascending; lines nearer than `doubled` count as
/// one.
std::vector<double> layers(const Marks& marks, double x, double doubled) {
  std::vector<double> ys;
  for (const FaceMark* mark : marks) add_crossings(*mark, x, ys);
  std::stable_sort(ys.begin(), ys.end());
  std::vector<double> out;
  std::vector<double> together;
  const auto flush = [&] {
    if (together.empty()) return;
    double sum = 0;
    for (const double y : together) sum += y;
    out.push_back(sum / static_cast<double>(together.size()));
    together.clear();
  };
  for (const double y : ys) {
    if (!together.empty() && y - together.back() > doubled) flush();
    together.push_back(y);
  }
  flush();
  return out;
}

BrowMeasure measure_brow(const Marks& all, bool right) {
  // Short strokes far from the rest are no part of a brow.
  double least = 1e300;
  for (const FaceMark* mark : all) least = std::min(least, mark->cost);
  Marks marks;
  for (const FaceMark* mark : all) {
    if (mark->cost <= least + k_less_likely) marks.push_back(mark);
  }
  const Extent extent = extent_of(marks);
  const Bend bend = bend_of(marks, extent);
  const double half = 0.5 * extent.width();
  BrowMeasure brow;
  brow.height = -bend.at;
  const double rise = right ? -bend.slope : bend.slope;  // to the outer end, up
  brow.tilt = half > 0 ? rise / half : 0;
  brow.bend = half > 0 ? 0.5 * bend.curve / half : 0;
  return brow;
}

/// Returns the mean height of the ends at the left and at the right.
double height_of_corners(const Marks& marks) {
  PxPoint left{1e300, 0}, right{-1e300, 0};
  for (const FaceMark* mark : marks) {
    for (const PxPoint& p : mark->points) {
      if (p.x < left.x) left = p;
      if (p.x > right.x) right = p;
    }
  }
  return 0.5 * (left.y + right.y);
}

EyeMeasure measure_eye(const Marks& borders, const Marks& pupils) {
  EyeMeasure eye;
  Marks both = borders;
  both.insert(both.end(), pupils.begin(), pupils.end());
  const Extent whole = extent_of(both);
  eye.top = -whole.low.y;
  if (borders.empty()) {
    eye.kind = EyeKind::dot;
    return eye;
  }
  double widest = 0;
  for (const FaceMark* mark : borders) widest = std::max(widest, mark->size().x);
  Marks wide;
  for (const FaceMark* mark : borders) {
    if (mark->size().x >= 0.55 * widest) wide.push_back(mark);
  }
  const Extent extent = extent_of(wide);
  eye.width = extent.width();
  const double middle = extent.middle();
  const double doubled = k_doubled * widest;
  const std::vector<double> ys = layers(wide, middle, doubled);
  const FaceMark* iris = nullptr;
  for (const FaceMark* mark : pupils) {
    if (mark->size().x < k_lash * mark->size().y) continue;  // a lash: dashes are eyes only without lids
    if (!iris || mark->size().x > iris->size().x) iris = mark;
  }
  double upper = 0, lower = 0, top = 0;
  bool between = true;
  if (ys.size() <= 1) {
    between = false;
  } else {
    lower = ys.back();
    upper = ys[ys.size() - 2];
    top = ys.front();
    if (iris != nullptr) {
      // The lids are those next to the iris.
      const double at = iris->middle().y;
      upper = ys.front();
      lower = iris->high.y;
      for (const double y : ys) {
        if (y <= at) upper = y;
      }
      for (auto y = ys.rbegin(); y != ys.rend(); ++y) {
        if (*y > std::max(at, upper)) lower = *y;
      }
    }
  }
  if (!between && iris == nullptr) {
    const Bend bend = bend_of(wide, extent);
    eye.kind = eye.width > 0 ? EyeKind::line : EyeKind::dot;
    eye.bend = eye.width > 0 ? bend.curve / eye.width : 0;
    return eye;
  }
  if (!between) {
    // One lid and an iris.
    const double y = ys.empty() ? iris->low.y : ys.front();
    upper = std::min(y, iris->middle().y);
    lower = iris->high.y;
    top = upper;
  }
  eye.opening = eye.width > 0 ? std::max(0.0, lower - upper) / eye.width : 0;
  if (lower > upper) eye.arched = (height_of_corners(wide) - upper) / (lower - upper);
  if (iris != nullptr) {
    const double radius = 0.5 * std::max(iris->size().x, iris->size().y);
    if (radius > k_small_pupil * std::max(1e-9, lower - upper)) {
      // What is drawn of an iris that a lid cuts is its lower part.
      const double center = iris->high.y - radius;
      eye.covered = (upper - (center - radius)) / (2 * radius);
    }
  }
  const bool lid_within =
      ys.size() >= 3 && top < upper && std::any_of(wide.begin(), wide.end(), [&](const FaceMark* m) {
        return m->closed && m->low.y <= top + doubled && m->high.y >= lower - doubled;
      });
  if (lid_within) eye.covered = (upper - top) / std::max(1e-9, lower - top);
  return eye;
}

/// How far a line strays from the parabola that fits it best: root mean square.
double strays(const FaceMark& mark) {
  const Extent extent{mark.low, mark.high};
  const Bend bend = bend_of({&mark}, extent);
  const double half = 0.5 * extent.width();
  double squares = 0;
  for (const PxPoint& p : mark.points) {
    const double t = half > 0 ? (p.x - extent.middle()) / half : 0;
    const double d = p.y - (bend.at + bend.slope * t + bend.curve * (t * t - 1.0 / 3.0));
    squares += d * d;
  }
  return std::sqrt(squares / static_cast<double>(mark.points.size()));
}

/// Returns whether the lips are drawn wavy, or a tongue hangs over the lower one.
bool is_queasy(const Marks& marks, const Extent& extent) {
  return std::any_of(marks.begin(), marks.end(), [&](const FaceMark* mark) {
    const PxPoint size = mark->size();
    const bool wide = size.x >= k_from_corner_to_corner * extent.width();
    if (wide) return !mark->closed && strays(*mark) > k_wavy * extent.width();
    const bool upright = size.y > k_tongue_upright * size.x;
    return upright && size.x > k_tongue_width * extent.width() && mark->high.y > extent.high.y;
  });
}

/// Returns the slanted line that is drawn for an angry or a sad eye, over a dot or alone, as a brow.
std::optional<BrowMeasure> brow_of_slanted_eye(const Marks& borders, const EyeMeasure& eye, bool right) {
  for (const FaceMark* mark : borders) {
    const double reach = geometry::distance(mark->points.front(), mark->points.back());
    if (reach < k_straight_slant * mark->length) return {};
  }
  if (borders.empty()) return {};
  BrowMeasure brow = measure_brow(borders, right);
  if (std::abs(brow.tilt) < k_slanted) return {};
  brow.height = eye.top + k_brow_gap.mean;
  return brow;
}

MouthMeasure measure_mouth(const Marks& marks, double scale) {
  MouthMeasure mouth;
  double widest = 0;
  for (const FaceMark* mark : marks) widest = std::max(widest, mark->size().x);
  Marks wide;
  for (const FaceMark* mark : marks) {
    if (mark->size().x >= k_from_corner_to_corner * widest) wide.push_back(mark);
  }
  const Extent extent = extent_of(wide);
  mouth.width = extent.width();
  mouth.relative_width = mouth.width / scale;
  mouth.queasy = is_queasy(marks, extent);
  const double w = std::max(1e-9, mouth.width);
  std::vector<double> ys = layers(wide, extent.middle(), k_doubled * w);
  // Lips meet in a shorter line.
  bool meet = false;
  if (ys.size() >= 2) {
    Marks between = wide;
    const double inset = k_seam_inset * w;
    double highest = 1e300, lowest = -1e300;
    for (const FaceMark* mark : marks) {
      const double y = mark->middle().y;
      const double share = (y - ys.front()) / (ys.back() - ys.front());
      const bool flat = !mark->closed && mark->size().y < k_flat_seam * mark->size().x;
      const bool within = flat && std::abs(share - 0.5) < k_middle_of_lips && mark->low.x > extent.low.x + inset &&
                          mark->high.x < extent.high.x - inset && mark->size().x >= k_seam * widest;
      if (!within) continue;
      meet = true;
      highest = std::min(highest, y);
      lowest = std::max(lowest, y);
      if (mark->size().x < k_from_corner_to_corner * widest) between.push_back(mark);
    }
    ys = layers(between, extent.middle(), k_doubled * w);
    // Two lines apart are the borders of an opening.
    meet = meet && lowest - highest < k_one_seam * w;
  }
  // Corners: the ends of all that is wide, near either side.
  std::array<double, 2> ends{0, 0};
  std::array<double, 2> counts{0, 0};
  for (const FaceMark* mark : wide) {
    for (const PxPoint& p : mark->points) {
      for (std::size_t side = 0; side < 2; ++side) {
        const double from_end = side == 0 ? p.x - extent.low.x : extent.high.x - p.x;
        if (from_end > 0.06 * w) continue;
        ends[side] += p.y;
        counts[side] += 1;
      }
    }
  }
  for (std::size_t side = 0; side < 2; ++side) ends[side] = counts[side] > 0 ? ends[side] / counts[side] : 0;
  if (ys.empty()) return mouth;
  mouth.lines = ys.size();
  double upper = ys.front(), lower = ys.front();
  const double total = ys.back() - ys.front();
  if (ys.size() == 2) {
    upper = ys[0];
    lower = ys[1];
    const bool around = std::any_of(wide.begin(), wide.end(), [](const FaceMark* mark) { return mark->closed; });
    // A lip and the line where it meets the other one.
    if (!around && total < k_lip_height * w) upper = lower;
  } else if (ys.size() == 3) {
    // Two lips and what is between them: shut. Or an open mouth with teeth, or with one lip.
    const double one = ys[1] - ys[0];
    const double other = ys[2] - ys[1];
    const bool narrow = mouth.width < k_narrow_mouth;
    const bool uneven = std::max(one, other) > k_uneven_lips * std::min(one, other);
    if (!narrow && total > (uneven ? k_open_height : k_highest_lips) * w) {
      upper = ys[0];
      lower = ys[2];
    } else if (narrow && uneven) {
      upper = one > other ? ys[0] : ys[1];
      lower = one > other ? ys[1] : ys[2];
    } else {
      upper = lower = ys[1];
    }
  } else if (ys.size() >= 4) {
    const bool open = total > k_open_height * w;
    upper = open ? ys[1] : ys[ys.size() / 2];
    lower = open ? ys[ys.size() - 2] : upper;
  }
  if (meet && mouth.width < k_narrow_mouth) upper = lower = 0.5 * (ys.front() + ys.back());
  mouth.gap = (lower - upper) / w;
  mouth.shut = ys.size() == 1 || upper == lower;
  const double middle = 0.5 * (upper + lower);
  for (std::size_t side = 0; side < 2; ++side) mouth.corners[side] = (middle - ends[side]) / w;
  mouth.upper = (middle - upper) / w;
  return mouth;
}

}  // namespace

FaceMeasures measure(const FaceLayout& layout) {
  FaceMeasures out;
  for (std::size_t side = 0; side < 2; ++side) {
    const Marks brows = marks_of(layout, FacePart::brow, side);
    if (!brows.empty()) out.brows[side] = measure_brow(brows, side == 1);
    const Marks borders = marks_of(layout, FacePart::eye, side);
    const Marks pupils = marks_of(layout, FacePart::pupil, side);
    if (borders.empty() && pupils.empty()) continue;
    out.eyes[side] = measure_eye(borders, pupils);
    if (out.brows[side]) continue;
    out.brows[side] = brow_of_slanted_eye(borders, *out.eyes[side], side == 1);
    if (out.brows[side]) out.eyes[side] = measure_eye({}, pupils.empty() ? borders : pupils);
  }
  for (std::size_t side = 0; side < 2; ++side) {
    const auto wrinkles = [&](FacePart part) {
      const Marks marks = marks_of(layout, part, side);
      return std::any_of(marks.begin(), marks.end(), [&](const FaceMark* mark) {
        return part == FacePart::cheek ? mark->size().y > k_wrinkle_height
                                       : mark->middle().y < k_wrinkles_above && mark->size().y < k_wrinkle_height;
      });
    };
    out.wrinkled[side] = wrinkles(FacePart::cheek) || wrinkles(FacePart::nose);
  }
  const Marks mouth = marks_of(layout, FacePart::mouth, {});
  if (!mouth.empty()) out.mouth = measure_mouth(mouth, layout.scale);
  return out;
}

bool contradicts(const FaceMeasures& drawn, const FaceMeasures& posed, const FaceMeasures& rest) {
  for (std::size_t side = 0; side < 2; ++side) {
    if (!drawn.brows[side] || !posed.brows[side] || !rest.brows[side]) continue;
    const double asked = drawn.brows[side]->tilt - rest.brows[side]->tilt;
    const double shown = posed.brows[side]->tilt - rest.brows[side]->tilt;
    if (std::abs(asked) > k_clear_tilt && shown * (asked > 0 ? 1.0 : -1.0) < k_shown * std::abs(asked)) return true;
  }
  if (!drawn.mouth || !posed.mouth || !rest.mouth) return false;
  const double gap = posed.mouth->gap - rest.mouth->gap;
  return gap < -k_clear_gap || (drawn.mouth->lines == 1 && gap > k_clear_gap);
}

}  // namespace penpose::portrait
