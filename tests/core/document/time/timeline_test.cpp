#include "core/document/time/timeline.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "core/document/time/timeline_editing.h"
#include "tests/support/models/sheet_model.h"
#include "tests/support/timelines.h"

namespace penpose::document {
namespace {

using tests::k_kinds;
using tests::random_timeline;
using tests::timeline_of;
using tests::with_kind;

rig::Pose sample(const Timeline& timeline, double time_s) { return tests::sampled(timeline, time_s); }

TEST(Timeline, MeetsItsKeysAndHoldsItsEnds) {
  for (const KeyKind kind : k_kinds) {
    const auto timeline = with_kind(timeline_of({1, 2, 4}, {0.25, 0.75, 0.5}), kind, 0.1);
    EXPECT_EQ(sample(timeline, -1)[0], 0.25);
    EXPECT_EQ(sample(timeline, 1)[0], 0.25);
    EXPECT_EQ(sample(timeline, 2)[0], 0.75);
    EXPECT_EQ(sample(timeline, 4)[0], 0.5);
    EXPECT_EQ(sample(timeline, 1e9)[0], 0.5);
  }
  EXPECT_EQ(sample(timeline_of({1}, {0.25}), 7)[0], 0.25);
}

TEST(Timeline, LinearGoesStraight) {
  const auto timeline = with_kind(timeline_of({1, 2, 4}, {0.25, 0.75, 0.5}), KeyKind::linear);
  EXPECT_NEAR(sample(timeline, 1.5)[0], 0.5, 1e-15);
  EXPECT_NEAR(sample(timeline, 3)[0], 0.625, 1e-15);
}

TEST(Timeline, SteppedHoldsAndEasesStartAndArriveSlowly) {
  const auto at = [](KeyKind kind, double time_s) {
    return sample(with_kind(timeline_of({1, 3}, {0.2, 0.6}), kind), time_s)[0];
  };
  EXPECT_EQ(at(KeyKind::stepped, 2.999), 0.2);
  EXPECT_EQ(at(KeyKind::stepped, 3), 0.6);
  // A square of time from the key, and one to the next.
  EXPECT_NEAR(at(KeyKind::ease_in, 1.5), 0.2 + 0.4 * 0.25 * 0.25, 1e-15);
  EXPECT_NEAR(at(KeyKind::ease_out, 2.5), 0.6 - 0.4 * 0.25 * 0.25, 1e-15);
  EXPECT_NEAR(at(KeyKind::ease, 2), 0.4, 1e-15);
  EXPECT_NEAR(at(KeyKind::ease, 1.02), 0.2, 2e-4);
  EXPECT_NEAR(at(KeyKind::ease, 2.98), 0.6, 2e-4);
}

TEST(Timeline, AFreeKeyLeavesWithItsSlope) {
  auto timeline = timeline_of({0, 1, 2}, {0, 0.5, 0});
  timeline.keys[1].controls = std::vector<ControlKey>{{KeyKind::free, 1.5, -2.0}};
  EXPECT_NEAR((sample(timeline, 1)[0] - sample(timeline, 1 - 1e-7)[0]) / 1e-7, 1.5, 1e-5);
  EXPECT_NEAR((sample(timeline, 1 + 1e-7)[0] - sample(timeline, 1)[0]) / 1e-7, -2.0, 1e-5);
}

TEST(Timeline, AControlGoesByItsOwnKeysAlone) {
  // Moments 0, 1, 2, 3; the second control has keys at 0 and 3 only.
  Timeline timeline;
  for (int k = 0; k < 4; ++k) timeline.keys.push_back({1.0 * k, rig::Pose{0.1 * k, k == 3 ? 1.0 : 0.0}, ""});
  const Timeline whole = timeline;
  for (const std::size_t k : {1U, 2U})
    timeline.keys[k].controls = std::vector<ControlKey>{{KeyKind::smooth, 0, 0}, {KeyKind::none, 0, 0}};
  const Timeline two{{timeline.keys[0], timeline.keys[3]}};
  for (const double time_s : {0.0, 0.3, 1.0, 1.7, 2.0, 2.9, 3.0}) {
    EXPECT_EQ(sample(timeline, time_s)[0], sample(whole, time_s)[0]) << time_s;
    EXPECT_EQ(sample(timeline, time_s)[1], sample(two, time_s)[1]) << time_s;
  }
  const std::vector<rig::Parameter> parameters{{"a", 0, 0, 1}, {"b", 0, 0, 1}};
  const Timeline still = settled(timeline, parameters);
  EXPECT_EQ(still.keys[1].pose[1], sample(two, 1)[1]) << "a pose at a key is what is seen there";
}

TEST(Timeline, WithoutAKeyAControlIsAsItIs) {
  Timeline timeline = timeline_of({0, 1}, {0.2, 0.4});
  for (PoseKey& key : timeline.keys) key.controls = std::vector<ControlKey>{{KeyKind::none, 0, 0}};
  EXPECT_EQ(document::sample(timeline, 0.5, rig::Pose{0.7})[0], 0.7);
  EXPECT_EQ(document::sample(Timeline{}, 0.5, rig::Pose{0.7})[0], 0.7);
}

TEST(Timeline, SmoothRisesWhereTheKeysRise) {
  const auto timeline = timeline_of({0, 0.1, 1, 1.05, 3}, {0, 0.01, 0.02, 0.9, 1});
  double before = -1e-300;
  for (double t = 0; t <= 3; t += 0.001) {
    const double value = sample(timeline, t)[0];
    ASSERT_GE(value, before - 1e-15) << t;
    before = value;
  }
}

TEST(Timeline, SmoothHasNoCornersAndEasesInAndOut) {
  const auto timeline = timeline_of({0, 1, 2, 3}, {0, 0.2, 0.6, 1});
  const auto slope = [&](double t) { return (sample(timeline, t + 1e-6)[0] - sample(timeline, t - 1e-6)[0]) / 2e-6; };
  for (const double t : {1.0, 2.0}) EXPECT_NEAR(slope(t - 1e-4), slope(t + 1e-4), 1e-3) << t;
  EXPECT_NEAR(slope(0.0001), 0, 1e-3);
  EXPECT_NEAR(slope(2.9999), 0, 1e-3);
  const auto two = timeline_of({0, 1}, {0, 1});
  EXPECT_NEAR(sample(two, 0.5)[0], 0.5, 1e-15);
  EXPECT_LT(sample(two, 0.1)[0], 0.05);
}

TEST(Timeline, NeverOvershootsItsKeys) {
  const Model model = tests::sheet_model();
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Timeline timeline = random_timeline(model, 8, seed);
    for (std::size_t k = 0; k + 1 < timeline.keys.size(); ++k) {
      const PoseKey& a = timeline.keys[k];
      const PoseKey& b = timeline.keys[k + 1];
      for (int i = 0; i < 50; ++i) {
        const auto pose = sample(timeline, a.time_s + (b.time_s - a.time_s) * i / 50);
        for (std::size_t p = 0; p < pose.size(); ++p) {
          ASSERT_GE(pose[p], std::min(a.pose[p], b.pose[p]));
          ASSERT_LE(pose[p], std::max(a.pose[p], b.pose[p]));
        }
      }
    }
  }
}

TEST(Timeline, SlopesAreFlatWhereTheCurveTurns) {
  EXPECT_EQ(monotone_slope(1, -0.5), 0);
  EXPECT_EQ(monotone_slope(-0.5, 0), 0);
  EXPECT_EQ(monotone_slope(1, 1), 1);
  EXPECT_EQ(monotone_slope(0.1, 4), 3 * 0.1) << "cut, so that neither segment overshoots";
}

}  // namespace
}  // namespace penpose::document
