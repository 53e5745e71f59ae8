#include "core/document/time/timeline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>

#include "core/document/time/animation_sampling.h"
#include "core/document/time/timeline_animation.h"
#include "core/document/time/timeline_editing.h"
#include "tests/support/document_hand.h"
#include "tests/support/models/test_rigs.h"

namespace penpose::document {
namespace {

Timeline timeline_of(const std::vector<double>& times, const std::vector<double>& values) {
  Timeline timeline;
  for (std::size_t i = 0; i < times.size(); ++i) timeline.keys.push_back({times[i], rig::Pose{values[i]}, ""});
  return timeline;
}

/// The pose at a time where every control has a key.
rig::Pose sample(const Timeline& timeline, double time_s) {
  return document::sample(timeline, time_s, rig::Pose(timeline.keys.front().pose.size(), 0.0));
}

constexpr std::array k_kinds{KeyKind::smooth,   KeyKind::linear, KeyKind::stepped, KeyKind::ease_in,
                             KeyKind::ease_out, KeyKind::ease,   KeyKind::free};

/// All keys of all controls in one kind.
Timeline with_kind(Timeline timeline, KeyKind kind, double slope = 0) {
  for (PoseKey& key : timeline.keys)
    key.controls = std::vector<ControlKey>(key.pose.size(), ControlKey{kind, slope, slope});
  return timeline;
}

/// Keys of all parameters of the sheet at uneven moments.
Timeline random_timeline(const Model& model, std::size_t keys, std::uint64_t seed, double least_s = 0.01) {
  std::mt19937_64 numbers(seed);
  const auto real = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(numbers() >> 11) * 0x1p-53;
  };
  Timeline timeline;
  double time = 0;
  for (std::size_t k = 0; k < keys; ++k) {
    PoseKey key;
    key.time_s = time += real(least_s, 2);
    rig::Pose pose;
    for (const rig::Parameter& p : model.rig->parameters()) {
      const double at = real(-0.5, 1.5);  // often at an end of the range
      pose.push_back(std::clamp(p.minimum + (p.maximum - p.minimum) * at, p.minimum, p.maximum));
    }
    key.pose = std::move(pose);
    timeline.keys.push_back(key);
  }
  return timeline;
}

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

TEST(Timeline, SlopesAreNoSteeperThanTheRangeAllows) {
  const std::vector<rig::Parameter> parameters{{"a", 0, 0, 1}};
  for (const double slope : {-80.0, -3.0, 0.5, 12.0, 1e9}) {
    auto timeline = with_kind(timeline_of({0, 0.5, 2}, {0.1, 0.9, 0.4}), KeyKind::free, slope);
    timeline = settled(timeline, parameters);
    double most = 0;
    for (double t = 0; t < 2; t += 0.001) {
      const double value = sample(timeline, t)[0];
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

TEST(Timeline, AViewerOfTheAnimationSeesTheSame) {
  const Model model = tests::sheet_model();
  for (const KeyKind kind : k_kinds) {
    for (const std::size_t keys : {1U, 2U, 3U, 9U}) {
      const Timeline timeline =
          settled(with_kind(random_timeline(model, keys, 5, 1), kind, 0.1), model.rig->parameters());
      const Animation animation = to_animation(model, timeline);
      EXPECT_EQ(animation.name, "timeline");
      EXPECT_EQ(duration_s(animation), timeline.keys.back().time_s);
      for (double t = 0; t < timeline.keys.back().time_s + 0.5; t += 0.037) {
        const auto pose = sample(timeline, t);
        const auto seen = sample(model, animation, t);
        ASSERT_EQ(seen.weights.size(), 2U);
        EXPECT_NEAR(seen.weights[0], pose[0], 1e-12) << t;
        EXPECT_NEAR(seen.weights[1], pose[1], 1e-12) << t;
        Model posed = model;
        posed.pose = pose;
        const auto expected = posed_positions(posed);
        const auto shown = posed_positions(model_at(model, seen).value());
        for (std::size_t v = 0; v < expected.size(); v += 17) {
          ASSERT_NEAR(geometry::distance(expected[v], shown[v]), 0, 2e-3) << t << " " << v;
        }
      }
    }
  }
}

TEST(Timeline, AViewerSeesControlsOfAllKindsBesideEachOther) {
  const Model model = tests::sheet_model();
  std::mt19937_64 numbers(3);
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Timeline timeline = random_timeline(model, 7, seed, 0.2);
    for (PoseKey& key : timeline.keys) {
      std::vector<ControlKey> list(key.pose.size());
      for (ControlKey& one : list) {
        one = {static_cast<KeyKind>(numbers() % 8), 0, 0};
        if (one.kind == KeyKind::free) one = {one.kind, 0.3, -0.4};
      }
      key.controls = list;
    }
    timeline = settled(timeline, model.rig->parameters());
    const Animation animation = to_animation(model, timeline);
    for (double t = 0; t < timeline.keys.back().time_s + 0.5; t += 0.0137) {
      const rig::Pose pose = document::sample(timeline, t, model.pose);
      const auto seen = document::sample(model, animation, t);
      for (std::size_t i = 0; i < 2; ++i) ASSERT_NEAR(seen.weights[i], pose[i], 1e-9) << seed << " " << t << " " << i;
    }
  }
}

TEST(Timeline, TheAnimationDrivesDeformersToo) {
  tests::DocumentHand hand;
  hand.sketch("up");
  hand.does(SetKey{0, ""});
  hand.does(SetParameters{{{"lift", 0.5}, {"up", 1}}});
  hand.does(SetKey{2, ""});
  const Model model = model_of(hand.document());
  const auto shown = model_at(model, sample(model, model.animations[0], 1)).value();
  EXPECT_NEAR(shown.pose[0], 0.25, 1e-12);
  EXPECT_NEAR(shown.pose[2], 0.5, 1e-12);
}

TEST(Timeline, JointsThatDoNotTurnHaveNoChannel) {
  const Model model = tests::sheet_model();
  Timeline timeline;
  timeline.keys = {{0, model.pose, ""}, {1, model.pose, ""}};
  rig::Pose later = model.pose;
  later[0] = 1;
  timeline.keys[1].pose = later;
  EXPECT_EQ(to_animation(model, timeline).channels.size(), 1U);
  later[3] = 0.1;
  timeline.keys[1].pose = later;
  EXPECT_EQ(to_animation(model, timeline).channels.size(), 2U);
  EXPECT_TRUE(to_animation(model, Timeline{}).channels.empty());
}

TEST(Timeline, IsTheFirstAnimationOfTheModel) {
  Model model = tests::sheet_model();
  model.animations = {{"walk", {}}};
  Document document = make_document(model);
  EXPECT_EQ(model_of(document).animations.size(), 1U);
  auto timeline = std::make_shared<Timeline>();
  timeline->keys = {{0, model.pose, ""}};
  document.timeline = timeline;
  document.pose[0] = 0.5;
  const Model whole = model_of(document);
  ASSERT_EQ(whole.animations.size(), 2U);
  EXPECT_EQ(whole.animations[0].name, "timeline");
  EXPECT_EQ(whole.animations[1].name, "walk");
  EXPECT_EQ(whole.pose, document.pose);
}

}  // namespace
}  // namespace penpose::document
