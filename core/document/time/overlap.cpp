#include "core/document/time/overlap.h"

#include <algorithm>
#include <cmath>

#include "core/base/math.h"
#include "core/document/time/thinning.h"

namespace penpose::document {
namespace {

constexpr int k_steps_a_frame = 8;
constexpr double k_same_frame = 1e-6;
/// A step on a frame is seen on a frame after a delay of whole ones, whatever their differences are rounded to.
constexpr double k_rounding_s = 1e-9;
/// The spring is at rest where it is so near to its end, as a share of the way, and so slow.
constexpr double k_overlap_at_rest = 0.003;
constexpr double k_longest_rest_periods = 14;

std::optional<double> own_key_before(const Timeline& timeline, std::size_t control, double time_s) {
  const std::size_t place = first_from(timeline, time_s);
  const auto key = place > 0 ? key_before(timeline, control, place - 1) : std::nullopt;
  return key ? std::optional(timeline.keys[*key].time_s) : std::nullopt;
}

std::optional<double> own_key_after(const Timeline& timeline, std::size_t control, double time_s) {
  for (std::size_t k = first_from(timeline, time_s); k < timeline.keys.size(); ++k) {
    if (timeline.keys[k].time_s > time_s && timeline.keys[k].controls.has(control)) return timeline.keys[k].time_s;
  }
  return std::nullopt;
}

}  // namespace

double damping_ratio(double swing) {
  if (!(swing > 0)) return 1;
  const double log = base::log(std::min(swing, k_most_swing));
  return -log / std::sqrt(base::k_pi * base::k_pi + log * log);
}

void SpringMotion::prepare(double step_s) {
  if (step_s == step_s_) return;
  step_s_ = step_s;
  frequency_ = 2 * base::k_pi / spring_.period_s;
  ratio_ = damping_ratio(spring_.swing);
  const double damped = frequency_ * std::sqrt(1 - ratio_ * ratio_);
  const double fades = base::exp(-ratio_ * frequency_ * step_s);
  const double cos = base::cos(damped * step_s);
  const double sin = damped > 0 ? base::sin(damped * step_s) / damped : step_s;
  keep_ = fades * (cos + ratio_ * frequency_ * sin);
  pass_ = fades * sin;
  pull_ = -fades * frequency_ * frequency_ * sin;
  keep_speed_ = fades * (cos - ratio_ * frequency_ * sin);
}

void SpringMotion::step(double from, double to, double step_s) {
  const double slope = (to - from) / step_s;
  if (!(spring_.period_s > 0)) {
    value_ = to;
    speed_ = slope;
    return;
  }
  prepare(step_s);
  // A way that goes on straight for ever is followed at this distance.
  const double behind = 2 * ratio_ * slope / frequency_;
  const double off = value_ - (from - behind);
  const double off_speed = speed_ - slope;
  value_ = to - behind + keep_ * off + pass_ * off_speed;
  speed_ = slope + pull_ * off + keep_speed_ * off_speed;
}

LedWay::LedWay(const Timeline& timeline, std::span<const rig::Parameter> parameters, const Overlap& overlap)
    : timeline_(timeline),
      range_(parameters[overlap.control]),
      overlap_(overlap),
      leads_(overlap.leader.value_or(overlap.control)),
      begin_s_(overlap.first_s),
      led_until_s_(overlap.last_s),
      next_s_(own_key_after(timeline, overlap.control, overlap.last_s)) {
  const auto value_at = [&](std::size_t control, double time_s) {
    return sample(timeline, control, time_s).value_or(parameters[control].rest);
  };
  const auto before = own_key_before(timeline, overlap.control, begin_s_);
  if (overlap.leader) {
    const rig::Parameter& other = parameters[leads_];
    const double span = other.maximum - other.minimum;
    scale_ = span > 0 ? overlap.amount * (range_.maximum - range_.minimum) / span : 0;
    const auto first = key_after(timeline, leads_, 0);
    const auto last = timeline.keys.empty() ? first : key_before(timeline, leads_, timeline.keys.size() - 1);
    if (!before && first) begin_s_ = std::min(begin_s_, timeline.keys[*first].time_s);
    if (!next_s_ && last) led_until_s_ = std::max(led_until_s_, timeline.keys[*last].time_s);
  }
  begin_value_ = value_at(overlap.control, begin_s_);
  leader_began_ = value_at(leads_, begin_s_);
  const double step_s = 1.0 / (overlap.rate * k_steps_a_frame);
  if (before && begin_s_ > step_s)
    begin_speed_ = (begin_value_ - value_at(overlap.control, begin_s_ - step_s)) / step_s;
  const double rests_from_s = led_until_s_ + overlap.delay_s;
  led_.push_back(led_at(begin_s_));
  for (Step step{begin_s_, 0}; !(step.to_s >= rests_from_s);) {
    step = step_after(step.to_s);
    for (int k = 1; k <= k_steps_a_frame; ++k) led_.push_back(led_at(step.to_s - (k_steps_a_frame - k) * step.part_s));
    if (next_s_ && step.to_s >= *next_s_) break;
  }
}

LedWay::Step LedWay::step_after(double time_s) const {
  const double rate = overlap_.rate;
  const double frame_s = 1.0 / rate;
  double to_s = (std::floor(time_s * rate + k_same_frame) + 1) / rate;
  if (next_s_ && to_s >= *next_s_ - k_same_frame * frame_s) to_s = *next_s_;
  // Frames are of one length but for the bits that their moments differ by.
  const bool whole = std::abs(to_s - time_s - frame_s) < k_same_frame * frame_s;
  return {to_s, (whole ? frame_s : to_s - time_s) / k_steps_a_frame};
}

double LedWay::led_at(double time_s) const {
  const double from_s =
      std::clamp(time_s - overlap_.delay_s + k_rounding_s, begin_s_, std::max(begin_s_, led_until_s_));
  const double value = sample(timeline_, leads_, from_s).value_or(leader_began_);
  return overlap_.leader ? begin_value_ + scale_ * (value - leader_began_) : value;
}

double LedWay::shown(double value, double time_s) const {
  if (next_s_ && time_s > overlap_.last_s) {
    const double u = std::min(1.0, (time_s - overlap_.last_s) / (*next_s_ - overlap_.last_s));
    const double share = u * u * (3 - 2 * u);
    value += share * (sample(timeline_, overlap_.control, time_s).value_or(value) - value);
  }
  return in_range(value);
}

template <typename More>
void LedWay::run(const Spring& spring, More more) const {
  SpringMotion motion(spring, begin_value_, begin_speed_);
  const double frame_s = 1.0 / overlap_.rate;
  const double rests_from_s = led_until_s_ + overlap_.delay_s;
  const double gives_up_s = rests_from_s + k_longest_rest_periods * spring.period_s + 2 * frame_s;
  const double end = led_.back();
  double most = 0;  // how far it was from its end
  double time_s = begin_s_;
  std::size_t led = 0;
  bool goes_on = more(time_s, shown(motion.value(), time_s));
  while (goes_on) {
    const Step step = step_after(time_s);
    for (int k = 0; k < k_steps_a_frame; ++k, ++led)
      motion.step(led_[std::min(led, led_.size() - 1)], led_[std::min(led + 1, led_.size() - 1)], step.part_s);
    time_s = step.to_s;
    const bool joins = next_s_ && time_s >= *next_s_;
    const double off = std::abs(motion.value() - end);
    const double speed = std::abs(motion.speed()) * std::max(spring.period_s / (2 * base::k_pi), frame_s);
    most = std::max(most, off);
    const bool rests = std::max(off, speed) <= k_overlap_at_rest * most || time_s >= gives_up_s;
    const bool over = joins || (!next_s_ && time_s >= rests_from_s && rests) || time_s + frame_s > k_latest_key_s;
    goes_on = more(time_s, shown(over && !joins ? end : motion.value(), time_s)) && !over;
  }
}

TrailingCurve LedWay::trailed(const Spring& spring) const {
  TrailingCurve curve{{}, {}, next_s_.has_value()};
  run(spring, [&](double time_s, double value) {
    curve.times_s.push_back(time_s);
    curve.values.push_back(value);
    return true;
  });
  return curve;
}

double LedWay::trailed_at(const Spring& spring, double time_s) const {
  double was_s = begin_s_;
  double was = begin_value_;
  double at = begin_value_;
  run(spring, [&](double now_s, double value) {
    const bool reached = now_s >= time_s;
    at = value;
    if (reached && now_s > was_s) at = was + (value - was) * std::clamp((time_s - was_s) / (now_s - was_s), 0.0, 1.0);
    was_s = now_s;
    was = value;
    return !reached;
  });
  return at;
}

TrailingKeys keys_of(const Timeline& timeline, std::size_t control, double last_s, const TrailingCurve& curve,
                     double tolerance) {
  // The keys before and behind the curve shape its ends.
  std::vector<double> times_s;
  std::vector<double> values;
  std::vector<std::size_t> fixed;
  const auto add = [&](double time_s, double value, bool stays) {
    if (stays) fixed.push_back(times_s.size());
    times_s.push_back(time_s);
    values.push_back(value);
  };
  const auto add_key = [&](std::optional<double> time_s) {
    if (time_s) add(*time_s, sample(timeline, control, *time_s).value_or(0), true);
  };
  add_key(own_key_before(timeline, control, curve.times_s.front()));
  const std::size_t from = times_s.size();
  const std::size_t count = curve.times_s.size();
  for (std::size_t i = 0; i < count; ++i) {
    // Keys go up to the last one that is meant, so that none of those stays between them.
    const bool last = curve.joins && i + 1 < count && curve.times_s[i] <= last_s && curve.times_s[i + 1] > last_s;
    add(curve.times_s[i], curve.values[i], i == 0 || i + 1 == count || last);
  }
  if (curve.joins) add_key(own_key_after(timeline, control, curve.times_s.back()));
  const auto [least, most] = std::minmax_element(curve.values.begin(), curve.values.end());
  const double allowed = std::max(tolerance * (*most - *least), 1e-12);
  TrailingKeys keys;
  for (const std::size_t moment : enough_moments({times_s, values, std::span(&allowed, 1)}, fixed)) {
    const bool within = moment >= from && moment < from + count - (curve.joins ? 1 : 0);
    if (!within) continue;
    keys.times_s.push_back(times_s[moment]);
    keys.values.push_back(values[moment]);
  }
  return keys;
}

}  // namespace penpose::document
