#include "core/document/time/overlap.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "core/document/time/timeline_editing.h"
#include "tests/support/timelines.h"

namespace penpose::document {
namespace {

using tests::timeline_of;
using tests::with_kind;

constexpr int k_overlap_rate = 24;

const std::vector<rig::Parameter> k_wide{{"a", 0, -4, 4}, {"b", 0, -1, 3}};

/// One control: up from 0 to 1 at half a second, at once.
Timeline step_up() { return with_kind(timeline_of({0, 0.5, 1}, {0, 1, 1}), KeyKind::stepped, 0); }

Overlap whole_keys(double last_s, double delay_frames) {
  Overlap overlap;
  overlap.last_s = last_s;
  overlap.delay_s = delay_frames / k_overlap_rate;
  overlap.rate = k_overlap_rate;
  return overlap;
}

/// When the curve first comes so far, s.
double comes_to(const TrailingCurve& curve, double value) {
  for (std::size_t i = 1; i < curve.values.size(); ++i) {
    if (curve.values[i] < value) continue;
    const double share = (value - curve.values[i - 1]) / (curve.values[i] - curve.values[i - 1]);
    return curve.times_s[i - 1] + share * (curve.times_s[i] - curve.times_s[i - 1]);
  }
  return 1e9;
}

TEST(Overlap, AStepTrailsByTheDelayToWithinHalfAFrame) {
  const Timeline timeline = step_up();
  for (const double delay : {0.0, 1.0, 2.5, 7.3}) {
    const LedWay way(timeline, k_wide, whole_keys(1, delay));
    const TrailingCurve stiff = way.trailed({});
    EXPECT_NEAR(comes_to(stiff, 0.5), 0.5 + delay / k_overlap_rate, 0.5 / k_overlap_rate + 1e-6) << delay;
    // A spring leaves at that moment too, and comes later.
    const TrailingCurve soft = way.trailed({12.0 / k_overlap_rate, 0});
    EXPECT_NEAR(comes_to(soft, 1e-9), 0.5 + delay / k_overlap_rate, 1.0 / k_overlap_rate) << delay;
    for (std::size_t i = 0; i < soft.values.size(); ++i) {
      if (soft.times_s[i] < 0.5 + (delay - 0.5) / k_overlap_rate) {
        EXPECT_EQ(soft.values[i], 0) << soft.times_s[i];
      }
    }
    EXPECT_GT(comes_to(soft, 0.5), comes_to(stiff, 0.5) + 1.0 / k_overlap_rate);
  }
}

TEST(Overlap, AStepIsOvershotByTheShareThatWasAskedFor) {
  const Timeline timeline = step_up();
  for (const double swing : {0.0, 0.05, 0.2, 0.5, 0.8}) {
    const TrailingCurve curve = LedWay(timeline, k_wide, whole_keys(1, 0)).trailed({2, swing});
    const double most = *std::max_element(curve.values.begin(), curve.values.end());
    // Between two frames the top is missed by little.
    EXPECT_NEAR(most - 1, swing, 0.004) << swing;
    EXPECT_EQ(curve.values.back(), 1) << "it comes to rest where it is led";
  }
  EXPECT_EQ(damping_ratio(0), 1);
  EXPECT_NEAR(std::exp(-M_PI * damping_ratio(0.3) / std::sqrt(1 - std::pow(damping_ratio(0.3), 2))), 0.3, 1e-12);
}

TEST(Overlap, ASpringMovesAsItsEquationSays) {
  for (const double swing : {0.0, 0.4}) {
    const Spring spring{0.5, swing};
    SpringMotion motion(spring, 0.2, -1);
    const double frequency = 2 * M_PI / spring.period_s;
    const double ratio = damping_ratio(swing);
    double value = 0.2;
    double speed = -1;
    double led = 0.1;
    constexpr int k_fine = 20000;
    for (const double to : {0.3, 0.9, 0.9, -0.4}) {
      motion.step(led, to, 0.07);
      for (int i = 0; i < k_fine; ++i) {
        const double middle = led + (to - led) * (i + 0.5) / k_fine;
        const double h = 0.07 / k_fine;
        const double half =
            speed + 0.5 * h * (frequency * frequency * (middle - value) - 2 * ratio * frequency * speed);
        value += h * half;
        speed += h * (frequency * frequency * (middle - value + 0.5 * h * half) - 2 * ratio * frequency * half);
      }
      EXPECT_NEAR(motion.value(), value, 1e-6);
      EXPECT_NEAR(motion.speed(), speed, 1e-5);
      led = to;
    }
  }
}

TEST(Overlap, AFewSmoothKeysAreTheSpring) {
  std::vector<double> times_s;
  std::vector<double> values;
  for (int k = 0; k <= 6; ++k) {
    times_s.push_back(k);
    values.push_back(k % 2 == 0 ? 0.2 : 0.8);
  }
  const Timeline timeline = timeline_of(times_s, values);
  const std::vector<rig::Parameter> parameters{{"a", 0, 0, 1}};
  for (const double swing : {0.0, 0.3}) {
    const TrailingCurve curve = LedWay(timeline, parameters, whole_keys(6, 3)).trailed({10.0 / k_overlap_rate, swing});
    const TrailingKeys keys = keys_of(timeline, 0, 6, curve, 0.01);
    EXPECT_LE(keys.times_s.size(), curve.times_s.size() / 4) << swing << " of " << curve.times_s.size();
    const Timeline baked = timeline_of(keys.times_s, keys.values);
    for (std::size_t i = 0; i < curve.times_s.size(); ++i) {
      EXPECT_NEAR(*sample(baked, 0, curve.times_s[i]), curve.values[i], 0.01 * 0.8) << curve.times_s[i];
      EXPECT_GE(curve.values[i], 0);
      EXPECT_LE(curve.values[i], 1);
    }
  }
}

TEST(Overlap, NothingLeavesTheRange) {
  const Timeline timeline = step_up();
  const std::vector<rig::Parameter> parameters{{"a", 0, 0, 1}};
  const TrailingCurve curve = LedWay(timeline, parameters, whole_keys(1, 1)).trailed({0.5, 0.8});
  EXPECT_EQ(*std::max_element(curve.values.begin(), curve.values.end()), 1);
  EXPECT_GE(*std::min_element(curve.values.begin(), curve.values.end()), 0);
}

TEST(Overlap, ALeadersMotionIsTakenByTheSharesOfBothRanges) {
  Timeline timeline;
  for (const auto& [time_s, a] : std::vector<std::pair<double, double>>{{0, 1}, {1, 3}, {2, 3}})
    timeline.keys.push_back({time_s, rig::Pose{a, 0.5}, ""});
  Overlap overlap = whole_keys(2, 4);
  overlap.control = 1;
  overlap.leader = 0;
  const LedWay way(timeline, k_wide, overlap);
  // Two of eight units are one of four.
  EXPECT_EQ(way.trailed({}).values.front(), 0.5);
  EXPECT_NEAR(way.trailed({}).values.back(), 1.5, 1e-12);
  EXPECT_NEAR(way.trailed_at({}, 0.5 + 4.0 / k_overlap_rate), 1.0, 1e-7);
  overlap.amount = -0.5;
  EXPECT_NEAR(LedWay(timeline, k_wide, overlap).trailed({}).values.back(), 0, 1e-12);
}

TEST(Overlap, APartOfTheKeysGoesOverIntoWhatIsAroundThem) {
  const Timeline timeline = timeline_of({0, 1, 2, 3, 4}, {0, 1, 0.2, 0.9, 0.4});
  Overlap overlap = whole_keys(2, 3);
  overlap.first_s = 1;
  const TrailingCurve curve = LedWay(timeline, k_wide, overlap).trailed({0.25, 0});
  EXPECT_TRUE(curve.joins);
  EXPECT_EQ(curve.times_s.front(), 1);
  EXPECT_EQ(curve.values.front(), 1);
  EXPECT_EQ(curve.times_s.back(), 3);
  EXPECT_NEAR(curve.values.back(), 0.9, 1e-12);
  double farthest = 0;
  for (std::size_t i = 1; i < curve.values.size(); ++i)
    farthest = std::max(farthest, std::abs(curve.values[i] - curve.values[i - 1]));
  EXPECT_LT(farthest, 0.12) << "no frame jumps";
  const TrailingKeys keys = keys_of(timeline, 0, 2, curve, 0.01);
  EXPECT_LT(keys.times_s.back(), 3) << "the next key stays";
  EXPECT_GE(keys.times_s.back(), 2) << "no key that is meant stays behind them";
}

TEST(Overlap, OneValueSaysHowStiffItIs) {
  const Timeline timeline = timeline_of({0, 0.5, 1.5, 2}, {0, 1, 1, 0.3});
  const LedWay way(timeline, k_wide, whole_keys(2, 2));
  for (const double swing : {0.0, 0.3}) {
    for (const double frames : {6.0, 17.0, 30.0}) {
      const Spring meant{frames / k_overlap_rate, swing};
      const double value = way.trailed_at(meant, 0.75);
      const FoundSpring found =
          spring_through(way, {1.05 * frames / k_overlap_rate, swing}, 0.75, value, k_overlap_rate);
      EXPECT_TRUE(found.passes);
      EXPECT_NEAR(found.value, value, 1e-9);
      EXPECT_NEAR(found.spring.period_s, meant.period_s, 1.0 / k_overlap_rate) << swing << " " << frames;
    }
  }
}

TEST(Overlap, WhereNoSpringComesTheNearestIsTaken) {
  const Timeline timeline = timeline_of({0, 0.5, 1.5, 2}, {0, 1, 1, 0.3});
  const LedWay way(timeline, k_wide, whole_keys(2, 2));
  const FoundSpring found = spring_through(way, {0.5, 0}, 0.75, 1.5, k_overlap_rate);
  EXPECT_FALSE(found.passes);
  for (double frames = 0; frames < 100; ++frames)
    EXPECT_LE(std::abs(found.value - 1.5), std::abs(way.trailed_at({frames / k_overlap_rate, 0}, 0.75) - 1.5) + 1e-9);
  // Before anything arrives, no stiffness makes a difference.
  const FoundSpring early = spring_through(way, {0.5, 0}, 1.0 / k_overlap_rate, 0.4, k_overlap_rate);
  EXPECT_FALSE(early.passes);
  EXPECT_EQ(early.spring, (Spring{0.5, 0}));
}

}  // namespace
}  // namespace penpose::document
