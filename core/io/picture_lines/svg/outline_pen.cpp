#include "core/io/picture_lines/svg/internal/outline_pen.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/math.h"
#include "core/geometry/lasso.h"

namespace penpose::io {
namespace {

using geometry::PxPoint;

constexpr double k_most_dash_pieces = 1000;  ///< of one curve

double length(PxPoint v) { return std::sqrt(geometry::dot(v, v)); }

/// In how many pieces a cubic curve is cut so that its polyline stays within a tolerance: Wang's bound from the second
/// differences of the control points (R. N. Goldman, Pyramid Algorithms, 2003, section 5.6.3).
int pieces_of(PxPoint a, PxPoint b, PxPoint c, PxPoint d, double tolerance) {
  const double bend = std::max(length(a - b * 2 + c), length(b - c * 2 + d));
  const double pieces = std::ceil(std::sqrt(0.75 * bend / tolerance));
  return static_cast<int>(pieces >= 1 ? std::min(pieces, k_most_dash_pieces) : 1.0);
}

/// The angle from the x axis (radians).
double angle_of(PxPoint v) { return base::atan2(v.y, v.x); }

}  // namespace

void OutlinePen::add(PxPoint px) {
  if (!(std::abs(px.x) <= geometry::k_largest_px && std::abs(px.y) <= geometry::k_largest_px)) {
    too_far_ = true;
    return;
  }
  auto& points = contours_.back().points;
  if (!points.empty() && points.back() == px) return;
  if (points_ == most_) {
    full_ = true;
    return;
  }
  ++points_;
  points.push_back(px);
}

void OutlinePen::move_to(Point p) {
  at_ = start_ = p;
  drawing_ = false;
}

void OutlinePen::begin_where_needed() {
  if (drawing_) return;
  drawing_ = true;
  contours_.emplace_back();
  add(to_px_(at_));
}

void OutlinePen::line_to(Point p) {
  begin_where_needed();
  add(to_px_(p));
  at_ = p;
}

void OutlinePen::curve_to(Point first, Point second, Point p) {
  begin_where_needed();
  const Point a = to_px_(at_);
  const Point b = to_px_(first);
  const Point c = to_px_(second);
  const Point d = to_px_(p);
  const int pieces = pieces_of(a, b, c, d, tolerance_);
  for (int i = 1; i < pieces && !full_ && !too_far_; ++i) {
    const double t = static_cast<double>(i) / pieces;
    const double s = 1 - t;
    add(a * (s * s * s) + b * (3 * s * s * t) + c * (3 * s * t * t) + d * (t * t * t));
  }
  add(d);
  at_ = p;
}

void OutlinePen::curve_to(Point middle, Point p) {
  const Point begin = at_;
  curve_to(begin + (middle - begin) * (2.0 / 3.0), p + (middle - p) * (2.0 / 3.0), p);
}

void OutlinePen::arc_to(Point radii, double turn, bool large, bool sweep, Point p) {
  double rx = std::abs(radii.x);
  double ry = std::abs(radii.y);
  if (at_ == p) return;
  if (!(rx > 0 && ry > 0)) return line_to(p);
  const double angle = base::radians(turn);
  const double cosine = base::cos(angle);
  const double sine = base::sin(angle);
  const auto turned = [&](Point v) { return Point{cosine * v.x - sine * v.y, sine * v.x + cosine * v.y}; };
  // Half of the chord in the ellipse's own axes, in units of the radii (F.6.5.1 and F.6.6.2).
  const Point half = (at_ - p) * 0.5;
  Point unit{(cosine * half.x + sine * half.y) / rx, (cosine * half.y - sine * half.x) / ry};
  const double square = geometry::dot(unit, unit);
  if (square > 1) {
    const double grown = std::sqrt(square);
    rx *= grown;
    ry *= grown;
    unit = unit * (1 / grown);
  }
  // The centre, at a right angle to the chord (F.6.5.2 in those units).
  const double reach = square > 1 || !(square > 0) ? 0 : std::sqrt((1 - square) / square);
  const Point centre = Point{unit.y, -unit.x} * (large == sweep ? -reach : reach);
  const double begin = angle_of(unit - centre);
  double across = angle_of(unit * -1 - centre) - begin;
  if (sweep && across < 0) across += 2 * base::k_pi;
  if (!sweep && across > 0) across -= 2 * base::k_pi;
  const Point middle = (at_ + p) * 0.5 + turned({centre.x * rx, centre.y * ry});
  // Cubic curves of at most 45 degrees are within 5e-6 of the radius.
  const double most = base::k_pi / 4;
  const int pieces = static_cast<int>(std::clamp(std::ceil(std::abs(across) / most - 1e-9), 1.0, 8.0));
  const double step = across / pieces;
  const double handle = 4.0 / 3.0 * base::tan(step / 4);
  const auto on_ellipse = [&](double x, double y) { return turned({x * rx, y * ry}); };
  for (int i = 0; i < pieces; ++i) {
    const double from = begin + step * i;
    const double to = from + step;
    const double c0 = base::cos(from);
    const double s0 = base::sin(from);
    const double c1 = base::cos(to);
    const double s1 = base::sin(to);
    const Point end = i + 1 == pieces ? p : middle + on_ellipse(c1, s1);
    curve_to(middle + on_ellipse(c0 - handle * s0, s0 + handle * c0),
             middle + on_ellipse(c1 + handle * s1, s1 - handle * c1), end);
  }
}

void OutlinePen::close() {
  if (drawing_) {
    line_to(start_);
    contours_.back().closed = true;
  }
  move_to(start_);
}

std::vector<Contour> OutlinePen::take() {
  std::erase_if(contours_, [](const Contour& one) { return one.points.size() < 2; });
  for (Contour& one : contours_) one.closed = one.closed || one.points.front() == one.points.back();
  return std::exchange(contours_, {});
}

}  // namespace penpose::io
