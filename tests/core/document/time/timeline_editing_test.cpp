#include "core/document/time/timeline_editing.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "tests/support/timelines.h"

namespace penpose::document {
namespace {

using tests::sampled;
using tests::timeline_of;
using tests::with_kind;

TEST(TimelineEditing, SlopesAreNoSteeperThanTheRangeAllows) {
  const std::vector<rig::Parameter> parameters{{"a", 0, 0, 1}};
  for (const double slope : {-80.0, -3.0, 0.5, 12.0, 1e9}) {
    auto timeline = with_kind(timeline_of({0, 0.5, 2}, {0.1, 0.9, 0.4}), KeyKind::free, slope);
    timeline = settled(timeline, parameters);
    double most = 0;
    for (double t = 0; t < 2; t += 0.001) {
      const double value = sampled(timeline, t)[0];
      ASSERT_GE(value, 0) << slope << " " << t;
      ASSERT_LE(value, 1) << slope << " " << t;
      most = std::max(most, value);
    }
    if (slope > 1) {
      EXPECT_GT(most, 0.99) << "no flatter than it must be";
    }
    EXPECT_EQ(settled(timeline, parameters), timeline);
  }
}

TEST(TimelineEditing, KeysComeAndGoByThemselvesAndEmptyMomentsWithThem) {
  const std::vector<rig::Parameter> parameters{{"a", 0, 0, 1}, {"b", 0, 0, 1}};
  Timeline timeline;
  for (const double time_s : {0.0, 1.0}) timeline.keys.push_back({time_s, rig::Pose{0.5 * time_s, 0.2}, "named"});
  TimelineEditing keys(timeline, parameters, {0.3, 0.4});
  keys.set(0.5, 0, 0.9, {});
  keys.erase(1, 0);
  keys.erase(1, 1);
  const Timeline after = std::move(keys).finish();
  ASSERT_EQ(after.keys.size(), 2U) << "the moment without keys is gone, its name with it";
  EXPECT_EQ(after.keys[1].time_s, 0.5);
  EXPECT_TRUE(after.keys[1].controls.has(0));
  EXPECT_FALSE(after.keys[1].controls.has(1));
  EXPECT_EQ(after.keys[1].pose[1], 0.2) << "what is seen of the other control there";
  EXPECT_EQ(key_at(after, 0.5), 1U);
  EXPECT_FALSE(key_at(after, 0.25));
}

TEST(TimelineEditing, ASpanThatIsOpenedLeavesWhatIsAroundItAsItWas) {
  const std::vector<rig::Parameter> parameters{{"a", 0, 0, 1}};
  for (const KeyKind kind : {KeyKind::smooth, KeyKind::linear, KeyKind::free}) {
    const Timeline before = with_kind(timeline_of({0, 1, 2, 3, 4}, {0.1, 0.5, 0.3, 0.8, 0.4}), kind, 0.05);
    TimelineEditing keys(before, parameters, {0.0});
    keys.open_span(0, 1.4, 2.5);
    const Timeline after = std::move(keys).finish();
    EXPECT_FALSE(key_at(after, 2)) << "keys in it are gone";
    for (double t = 0; t < 4.2; t += 0.05) {
      if (t > 1.4 && t < 2.5) continue;
      ASSERT_NEAR(sampled(after, t)[0], sampled(before, t)[0], 1e-12) << static_cast<int>(kind) << " " << t;
    }
  }
}

}  // namespace
}  // namespace penpose::document
