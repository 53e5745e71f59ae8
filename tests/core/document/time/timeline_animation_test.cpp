#include "core/document/time/timeline_animation.h"

#include <gtest/gtest.h>

#include "core/document/time/animation_sampling.h"
#include "core/document/time/timeline_editing.h"
#include "tests/support/document_hand.h"
#include "tests/support/models/test_rigs.h"
#include "tests/support/timelines.h"

namespace penpose::document {
namespace {

using tests::k_kinds;
using tests::random_timeline;
using tests::sampled;
using tests::with_kind;

TEST(TimelineAnimation, AViewerOfTheAnimationSeesTheSame) {
  const Model model = tests::sheet_model();
  for (const KeyKind kind : k_kinds) {
    for (const std::size_t keys : {1U, 2U, 3U, 9U}) {
      const Timeline timeline =
          settled(with_kind(random_timeline(model, keys, 5, 1), kind, 0.1), model.rig->parameters());
      const Animation animation = to_animation(model, timeline);
      EXPECT_EQ(animation.name, "timeline");
      EXPECT_EQ(duration_s(animation), timeline.keys.back().time_s);
      for (double t = 0; t < timeline.keys.back().time_s + 0.5; t += 0.037) {
        const auto pose = sampled(timeline, t);
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

TEST(TimelineAnimation, AViewerSeesControlsOfAllKindsBesideEachOther) {
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

TEST(TimelineAnimation, TheAnimationDrivesDeformersToo) {
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

TEST(TimelineAnimation, JointsThatDoNotTurnHaveNoChannel) {
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

TEST(TimelineAnimation, IsTheFirstAnimationOfTheModel) {
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
