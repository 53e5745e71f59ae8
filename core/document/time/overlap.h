#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/document/time/timeline.h"

namespace penpose::document {

/// A damped spring by what an animator sees of it.
struct Spring {
  double period_s = 0;  ///< of its swing were it not damped, >= 0; 0: it is stiff, and does not lag
  double swing = 0;     ///< how far it swings past the end of a step, as a share of the step; 0: critically damped
  friend bool operator==(const Spring&, const Spring&) = default;
};

/// Springs that swing farther do not come to rest within the time of a shot.
inline constexpr double k_most_swing = 0.8;
inline constexpr double k_longest_period_frames = 96;

/// The damping ratio with which a step is overshot by that share, 0..k_most_swing: 1 for none, else
/// -ln s / sqrt(pi^2 + ln^2 s).
[[nodiscard]] double damping_ratio(double swing);

/// A mass at the end of a spring whose other end is led: x'' = w^2 (u - x) - 2 z w x', solved in closed form for a u
/// that moves straight within each step.
class SpringMotion {
 public:
  SpringMotion(const Spring& spring, double value, double speed) : spring_(spring), value_(value), speed_(speed) {}

  /// The leading end goes from one value to another within `step_s` > 0.
  void step(double from, double to, double step_s);
  [[nodiscard]] double value() const { return value_; }
  /// Units a second.
  [[nodiscard]] double speed() const { return speed_; }

 private:
  void prepare(double step_s);

  Spring spring_;
  double value_;
  double speed_;
  double step_s_ = 0;  ///< what follows is of steps so long
  double frequency_ = 0, ratio_ = 1;
  double keep_ = 0, pass_ = 0, pull_ = 0, keep_speed_ = 0;  ///< what becomes of value and speed about the way led
};

/// A control that trails: what it trails, and by how much.
struct Overlap {
  std::size_t control = 0;
  std::optional<std::size_t> leader;  ///< whose motion; nothing: the control's own
  double first_s = 0, last_s = 0;  ///< the first and the last of the control's keys that are meant, first_s <= last_s
  double delay_s = 0;              ///< >= 0
  double amount = 1;               ///< of a leader's motion, as a share of the ranges of both; below 0: against it
  int rate = 24;                   ///< frames a second, > 0: there is a value a frame
};

/// A control as it trails, frame by frame. Nothing leaves its range.
struct TrailingCurve {
  std::vector<double> times_s;  ///< ascending, at least two; all on frames but the first, which is where the keys begin
  std::vector<double> values;   ///< one a moment
  bool joins = false;           ///< the last moment is that of the control's next key, which stays
};

/// The way along which a control is led. It begins at the first key that is meant (of a leader with earlier keys, at
/// those, unless the control has a key before), with the value and the speed that the control has there. Behind the
/// last one it ends where the spring has come to rest or, where the control has another key, at that one: there it goes
/// over into the control's own curve.
class LedWay {
 public:
  /// Preconditions: the control has keys at first_s and last_s; the timeline and the parameters stay.
  LedWay(const Timeline& timeline, std::span<const rig::Parameter> parameters, const Overlap& overlap);

  [[nodiscard]] TrailingCurve trailed(const Spring& spring) const;
  /// Its value at a moment, between two frames straight.
  [[nodiscard]] double trailed_at(const Spring& spring, double time_s) const;
  [[nodiscard]] double in_range(double value) const { return std::clamp(value, range_.minimum, range_.maximum); }

 private:
  /// Up to a frame or to the next key, in parts within which the way is taken to be straight.
  struct Step {
    double to_s = 0, part_s = 0;
  };
  [[nodiscard]] Step step_after(double time_s) const;
  [[nodiscard]] double led_at(double time_s) const;
  [[nodiscard]] double shown(double value, double time_s) const;
  /// Hands on each moment with its value until `more(time_s, value)` says that it is enough.
  template <typename More>
  void run(const Spring& spring, More more) const;

  const Timeline& timeline_;
  rig::Parameter range_;
  Overlap overlap_;
  std::size_t leads_;  ///< the control whose motion is followed
  double scale_ = 1;   ///< units of the control in one of the leader
  double begin_s_ = 0;
  double led_until_s_ = 0;  ///< behind it nothing leads any more
  std::optional<double> next_s_;
  double begin_value_ = 0, begin_speed_ = 0, leader_began_ = 0;
  std::vector<double> led_;  ///< a value at each part's end, until nothing leads any more
};

/// Few keys for a trailing curve, all smooth: between them no frame is off by more than `tolerance` of the way between
/// the curve's least and greatest value.
struct TrailingKeys {
  std::vector<double> times_s;  ///< ascending; the first is that of the curve
  std::vector<double> values;
};
[[nodiscard]] TrailingKeys keys_of(const Timeline& timeline, std::size_t control, double last_s,
                                   const TrailingCurve& curve, double tolerance);

/// The spring whose curve passes through a value at a moment, found by its period; its swing stays.
struct FoundSpring {
  Spring spring;
  bool passes = false;  ///< else none does, and this one comes nearest
  double value = 0;     ///< where it is at that moment
};
/// Of several, the one whose period is nearest to `now`. A value beyond the control's range is its end.
[[nodiscard]] FoundSpring spring_through(const LedWay& way, const Spring& now, double time_s, double value, int rate);

}  // namespace penpose::document
