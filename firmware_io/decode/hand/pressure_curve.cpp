#include "firmware_io/decode/hand/pressure_curve.h"

#include <algorithm>
#include <string>

namespace penpose::decode {

base::Result<PressureCurve> PressureCurve::make(std::vector<Point> points) {
  const auto wrong = [](std::size_t index, const char* what) {
    return base::Error{std::string("pressure curve: ") + what, "point " + std::to_string(index),
                       "give points from 0 to 1 in rising order"};
  };
  if (points.size() < 2) return wrong(0, "fewer than two points");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& point = points[i];
    const bool inside = point.pressed >= 0 && point.pressed <= 1 && point.meant >= 0 && point.meant <= 1;
    if (!inside) return wrong(i, "a number outside of 0..1");
    if (i > 0 && point.pressed <= points[i - 1].pressed) return wrong(i, "pressure as pressed does not rise");
    if (i > 0 && point.meant < points[i - 1].meant) return wrong(i, "pressure as meant falls");
  }
  if (points.front().pressed > 0) return wrong(0, "does not start at 0");
  if (points.back().pressed < 1) return wrong(points.size() - 1, "does not end at 1");
  PressureCurve curve;
  curve.points_ = std::move(points);
  return curve;
}

double PressureCurve::operator()(double pressed) const {
  const double clamped = pressed > 0 ? std::min(pressed, 1.0) : 0.0;  // NaN counts as 0
  if (points_.empty()) return clamped;
  const auto after = std::find_if(points_.begin() + 1, points_.end(),
                                  [clamped](const Point& point) { return clamped <= point.pressed; });
  const auto right = after == points_.end() ? points_.end() - 1 : after;
  const auto left = right - 1;
  const double along = (clamped - left->pressed) / (right->pressed - left->pressed);
  return left->meant + along * (right->meant - left->meant);
}

}  // namespace penpose::decode
