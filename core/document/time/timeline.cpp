#include "core/document/time/timeline.h"

#include <algorithm>
#include <cmath>

namespace penpose::document {
namespace {

constexpr double k_steepest_slope = 1e12;

bool all_usual(std::span<const ControlKey> keys) {
  return std::all_of(keys.begin(), keys.end(), [](const ControlKey& key) { return key == ControlKey{}; });
}

/// A cubic Hermite curve at u in 0..1, and its derivative by u.
struct Hermite {
  double a, b, to_slope_a, to_slope_b;  ///< slopes by u
  [[nodiscard]] double at(double u) const {
    const double u2 = u * u;
    const double u3 = u2 * u;
    return (2 * u3 - 3 * u2 + 1) * a + (u3 - 2 * u2 + u) * to_slope_a + (3 * u2 - 2 * u3) * b + (u3 - u2) * to_slope_b;
  }
  [[nodiscard]] double slope(double u) const {
    const double u2 = u * u;
    return (6 * u2 - 6 * u) * a + (3 * u2 - 4 * u + 1) * to_slope_a + (6 * u - 6 * u2) * b +
           (3 * u2 - 2 * u) * to_slope_b;
  }
};

Hermite hermite_of(const KeySegment& segment) {
  const double length_s = segment.to_s - segment.from_s;
  return {segment.from, segment.to, length_s * segment.slope_from, length_s * segment.slope_to};
}

double share_at(const KeySegment& segment, double time_s) {
  return (time_s - segment.from_s) / (segment.to_s - segment.from_s);
}

double secant(const Timeline& timeline, std::size_t parameter, std::size_t from, std::size_t to) {
  const PoseKey& a = timeline.keys[from];
  const PoseKey& b = timeline.keys[to];
  // Keys may be closer than numbers are fine.
  return std::clamp((b.pose[parameter] - a.pose[parameter]) / (b.time_s - a.time_s), -k_steepest_slope,
                    k_steepest_slope);
}

double smooth_slope(const Timeline& timeline, std::size_t parameter, std::size_t place) {
  const auto before = place > 0 ? key_before(timeline, parameter, place - 1) : std::nullopt;
  const auto after = key_after(timeline, parameter, place + 1);
  // A straight line to an end would start and stop with a jerk; flat ends ease in and out.
  if (!before || !after) return 0;
  return monotone_slope(secant(timeline, parameter, *before, place), secant(timeline, parameter, place, *after));
}

}  // namespace

ControlKeys::ControlKeys(std::vector<ControlKey> keys) {
  if (!all_usual(keys)) keys_ = std::make_shared<const std::vector<ControlKey>>(std::move(keys));
}

bool ControlKeys::whole() const {
  return !keys_ ||
         std::none_of(keys_->begin(), keys_->end(), [](const ControlKey& key) { return key.kind == KeyKind::none; });
}

bool ControlKeys::empty() const {
  return keys_ &&
         std::all_of(keys_->begin(), keys_->end(), [](const ControlKey& key) { return key.kind == KeyKind::none; });
}

std::vector<ControlKey> ControlKeys::list(std::size_t parameters) const {
  return keys_ ? *keys_ : std::vector<ControlKey>(parameters);
}

std::size_t first_from(const Timeline& timeline, double time_s) {
  const auto key = std::lower_bound(timeline.keys.begin(), timeline.keys.end(), time_s,
                                    [](const PoseKey& one, double time) { return one.time_s < time; });
  return static_cast<std::size_t>(key - timeline.keys.begin());
}

double value_at(const KeySegment& segment, double time_s) {
  if (segment.kind == KeyKind::stepped) return time_s < segment.to_s ? segment.from : segment.to;
  const double u = share_at(segment, time_s);
  if (segment.kind == KeyKind::linear) return segment.from + (segment.to - segment.from) * u;
  return hermite_of(segment).at(u);
}

double slope_at(const KeySegment& segment, double time_s) {
  if (segment.kind == KeyKind::stepped) return 0;
  if (segment.kind == KeyKind::linear) return segment.slope_from;
  return hermite_of(segment).slope(share_at(segment, time_s)) / (segment.to_s - segment.from_s);
}

std::pair<double, double> extremes(const KeySegment& segment) {
  double least = std::min(segment.from, segment.to);
  double most = std::max(segment.from, segment.to);
  if (segment.kind == KeyKind::stepped || segment.kind == KeyKind::linear) return {least, most};
  // The derivative is the quadratic a u^2 + b u + c.
  const Hermite curve = hermite_of(segment);
  const double a = 6 * (curve.a - curve.b) + 3 * (curve.to_slope_a + curve.to_slope_b);
  const double b = 6 * (curve.b - curve.a) - 4 * curve.to_slope_a - 2 * curve.to_slope_b;
  const double c = curve.to_slope_a;
  const auto note = [&](double u) {
    if (!(u > 0 && u < 1)) return;
    least = std::min(least, curve.at(u));
    most = std::max(most, curve.at(u));
  };
  const double inside = b * b - 4 * a * c;
  if (inside < 0) return {least, most};
  // Without the difference of nearly equal numbers.
  const double q = -0.5 * (b + std::copysign(std::sqrt(inside), b));
  if (a != 0) note(q / a);
  if (q != 0) note(c / q);
  return {least, most};
}

std::optional<std::size_t> key_before(const Timeline& timeline, std::size_t parameter, std::size_t place) {
  for (std::size_t k = std::min(place + 1, timeline.keys.size()); k-- > 0;) {
    if (timeline.keys[k].controls.has(parameter)) return k;
  }
  return std::nullopt;
}

std::optional<std::size_t> key_after(const Timeline& timeline, std::size_t parameter, std::size_t place) {
  for (std::size_t k = place; k < timeline.keys.size(); ++k) {
    if (timeline.keys[k].controls.has(parameter)) return k;
  }
  return std::nullopt;
}

KeySegment segment_of(const Timeline& timeline, std::size_t parameter, std::size_t from, std::size_t to) {
  const PoseKey& a = timeline.keys[from];
  const PoseKey& b = timeline.keys[to];
  const ControlKey begin = a.controls[parameter];
  const ControlKey end = b.controls[parameter];
  KeySegment segment{a.time_s, b.time_s, a.pose[parameter], b.pose[parameter], 0, 0, begin.kind};
  const double straight = secant(timeline, parameter, from, to);
  switch (begin.kind) {
    case KeyKind::smooth:
    case KeyKind::free:
    case KeyKind::overshoot:
      segment.slope_from = has_slopes(begin.kind) ? begin.out : smooth_slope(timeline, parameter, from);
      segment.slope_to = has_slopes(end.kind) ? end.in : smooth_slope(timeline, parameter, to);
      segment.overshoots = begin.kind == KeyKind::overshoot || end.kind == KeyKind::overshoot;
      break;
    case KeyKind::linear:
      segment.slope_from = segment.slope_to = straight;
      break;
    case KeyKind::ease_in:
      segment.slope_to = 2 * straight;
      break;
    case KeyKind::ease_out:
      segment.slope_from = 2 * straight;
      break;
    case KeyKind::stepped:
    case KeyKind::ease:
    case KeyKind::none:
      break;
  }
  return segment;
}

ControlKey with_slopes(const Timeline& timeline, std::size_t place, std::size_t parameter) {
  ControlKey key = timeline.keys[place].controls[parameter];
  if (has_slopes(key.kind)) return key;
  const auto before = place > 0 ? key_before(timeline, parameter, place - 1) : std::nullopt;
  const auto after = key_after(timeline, parameter, place + 1);
  key.in = before ? segment_of(timeline, parameter, *before, place).slope_to : 0;
  key.out = after ? segment_of(timeline, parameter, place, *after).slope_from : 0;
  return key;
}

namespace {

/// Of one control at a moment between the keys `place` and `place + 1` of the list.
std::optional<double> sampled(const Timeline& timeline, std::size_t parameter, std::size_t place, double time_s) {
  const auto before = key_before(timeline, parameter, place);
  const auto after = key_after(timeline, parameter, place + 1);
  if (!before && !after) return std::nullopt;
  if (!before || !after) return timeline.keys[before ? *before : *after].pose[parameter];
  const KeySegment segment = segment_of(timeline, parameter, *before, *after);
  const double value = value_at(segment, time_s);
  const bool end_has_slopes = has_slopes(timeline.keys[*after].controls[parameter].kind);
  if (has_slopes(segment.kind) || (segment.kind == KeyKind::smooth && end_has_slopes)) return value;
  // Rounding alone could leave the keys' span, and with it the parameter's range.
  return std::clamp(value, std::min(segment.from, segment.to), std::max(segment.from, segment.to));
}

/// The last key of the list at or before a moment; the first, where it is later.
std::size_t place_of(const Timeline& timeline, double time_s) {
  const std::size_t place = first_from(timeline, time_s);
  const bool at_key = place < timeline.keys.size() && timeline.keys[place].time_s == time_s;
  return at_key || place == 0 ? place : place - 1;
}

/// Before the first key of the list, or no later than it, the first key of a control is what holds.
bool before_all(const Timeline& timeline, double time_s) { return time_s <= timeline.keys.front().time_s; }

}  // namespace

std::optional<double> sample(const Timeline& timeline, std::size_t parameter, double time_s) {
  if (timeline.keys.empty()) return std::nullopt;
  if (before_all(timeline, time_s)) {
    const auto first = key_after(timeline, parameter, 0);
    return first ? std::optional(timeline.keys[*first].pose[parameter]) : std::nullopt;
  }
  return sampled(timeline, parameter, place_of(timeline, time_s), time_s);
}

rig::Pose sample(const Timeline& timeline, double time_s, rig::Pose unkeyed) {
  for (std::size_t i = 0; i < unkeyed.size(); ++i) {
    if (const auto value = sample(timeline, i, time_s)) unkeyed[i] = *value;
  }
  return unkeyed;
}

double monotone_slope(double secant_before, double secant_after) {
  if (secant_before * secant_after <= 0.0) return 0;
  // The square of side 3.
  const double limit = 3.0 * std::min(std::abs(secant_before), std::abs(secant_after));
  return std::clamp(0.5 * (secant_before + secant_after), -limit, limit);
}

}  // namespace penpose::document
