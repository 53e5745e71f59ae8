#include "core/document/time/animation_poses.h"

#include <gtest/gtest.h>

#include "core/document/time/timeline_animation.h"
#include "tests/support/models/sheet_model.h"

namespace penpose::document {
namespace {

TEST(AnimationPoses, ATimelineWrittenAsAnAnimationGivesItsKeysBack) {
  const Model model = tests::sheet_model();
  Timeline timeline;
  timeline.keys = {{0, rig::Pose{0.2, -0.5, 0.3, 0, 0}, ""},
                   {0.5, rig::Pose{0.9, 0.25, -0.2, 0.4, 0.1}, ""},
                   {2, rig::Pose{0, 1, 0, 0, -1}, ""}};
  for (PoseKey& key : timeline.keys) key.controls = std::vector<ControlKey>(5, {KeyKind::linear, 0, 0});
  // Joints have no keys in between at this rate.
  const Animation animation = to_animation(model, timeline, 0.01);
  const auto moments = moments_of(animation);
  EXPECT_EQ(moments, (std::vector<double>{0, 0.5, 2})) << "channels that share their moments have each once";
  const auto keys = poses_at(model, animation, moments);
  ASSERT_EQ(keys.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(keys[k].time_s, timeline.keys[k].time_s);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(keys[k].pose[i], timeline.keys[k].pose[i], 1e-12) << k << " " << i;
  }
}

TEST(AnimationPoses, StayWithinTheRangesAndWithoutKeysThereAreNone) {
  const Model model = tests::sheet_model();
  Animation wild{"wild", {}};
  EXPECT_TRUE(moments_of(wild).empty());
  Channel weights;
  weights.times_s = {0, 1};
  weights.values = {7, -9, 0.5, 0.5};
  wild.channels.push_back(weights);
  Channel moved;
  moved.target = ChannelTarget::translation;
  moved.times_s = {0.25};
  moved.values = {1, 2, 3};
  wild.channels.push_back(moved);
  Channel turned;
  turned.target = ChannelTarget::rotation;
  turned.times_s = {0.5};
  turned.values = {1, 0, 0, 0};
  wild.channels.push_back(turned);
  const auto moments = moments_of(wild);
  EXPECT_EQ(moments, (std::vector<double>{0, 0.5, 1})) << "what has no parameter makes no key";
  for (const PoseKey& key : poses_at(model, wild, moments)) {
    for (std::size_t i = 0; i < key.pose.size(); ++i) {
      EXPECT_GE(key.pose[i], model.rig->parameters()[i].minimum);
      EXPECT_LE(key.pose[i], model.rig->parameters()[i].maximum);
    }
  }
}

}  // namespace
}  // namespace penpose::document
