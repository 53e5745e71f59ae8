#include "core/document/time/clips/animation_keys.h"

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include "core/document/time/animation_poses.h"
#include "core/document/time/animation_sampling.h"
#include "core/geometry/rotation.h"
#include "tests/support/models/sheet_model.h"

namespace penpose::document {
namespace {

Channel turning(const Model& model, Interpolation interpolation, const std::vector<glm::dvec3>& angles) {
  Channel channel{ChannelTarget::rotation, model.skeleton->joint_of(0), interpolation, {}, {}};
  const glm::dquat rest = model.skeleton->joints()[channel.joint].rest_rotation;
  for (std::size_t k = 0; k < angles.size(); ++k) {
    channel.times_s.push_back(0.5 * static_cast<double>(k));
    const glm::dquat q = rest * geometry::quaternion_from_xyz(angles[k]);
    channel.values.insert(channel.values.end(), {q.x, q.y, q.z, q.w});
  }
  return channel;
}

/// The widest angle between what the animation and the keys make of the joint, radians.
double widest(const Model& model, const Animation& animation, const Timeline& keys) {
  const std::size_t first = weight_count(model);
  double worst = 0;
  for (double t = 0; t <= duration_s(animation); t += 0.013) {
    const JointTransform is = sample(model, animation, t).joints[model.skeleton->joint_of(0)];
    const rig::Pose pose = sample(keys, t, model.pose);
    const glm::dquat rest = model.skeleton->joints()[model.skeleton->joint_of(0)].rest_rotation;
    const glm::dquat shown = rest * geometry::quaternion_from_xyz({pose[first], pose[first + 1], pose[first + 2]});
    worst = std::max(worst, 2 * std::acos(std::min(1.0, std::abs(glm::dot(is.rotation, shown)))));
  }
  return worst;
}

TEST(AnimationKeys, TurnsAreWithinAThirdOfADegreeBetweenKeys) {
  const Model model = tests::sheet_model();
  const std::vector<glm::dvec3> angles{{0, 0, 0}, {1.2, -0.6, 0.9}, {-0.8, 1.1, -0.3}, {-0.8, 1.1, -0.3}, {0.2, 0, 1}};
  const Animation animation{"turn", {turning(model, Interpolation::linear, angles)}};
  const auto keys = keys_of(model, animation);
  ASSERT_TRUE(keys.ok());
  EXPECT_LT(widest(model, animation, *keys), 0.34 * 3.14159 / 180);
  EXPECT_LT(keys->keys.size(), 200U);
}

TEST(AnimationKeys, HeldTurnsAreStepped) {
  const Model model = tests::sheet_model();
  const Animation animation{"turn", {turning(model, Interpolation::step, {{0, 0, 0}, {0.5, 0, 0}, {0.25, 0, 0}})}};
  const auto keys = keys_of(model, animation);
  ASSERT_TRUE(keys.ok());
  EXPECT_EQ(keys->keys.size(), 3U);
  EXPECT_NEAR(sample(*keys, weight_count(model), 0.49).value(), 0, 1e-12);
  EXPECT_NEAR(sample(*keys, weight_count(model), 0.5).value(), 0.5, 1e-12);
}

TEST(AnimationKeys, KeysWhereNothingMovesAreLeftOut) {
  const Model model = tests::sheet_model();
  Channel channel{ChannelTarget::weights, 0, Interpolation::linear, {}, {}};
  for (int frame = 0; frame <= 100; ++frame) {
    channel.times_s.push_back(frame / 25.0);
    channel.values.insert(channel.values.end(), {frame < 40 ? 0.25 : 0.75, 0.5});
  }
  const auto keys = keys_of(model, {"held", {channel}});
  ASSERT_TRUE(keys.ok());
  EXPECT_EQ(keys->keys.size(), 4U) << "its ends and the jump";
  for (double t = 0; t < 4; t += 0.01)
    EXPECT_NEAR(sample(*keys, 0, t).value(), sample(model, {"held", {channel}}, t).weights[0], 1e-12) << t;
  EXPECT_EQ(sample(*keys, 1, 3).value(), 0.5);
}

TEST(AnimationKeys, AnAnimationThatIsTooLongIsRefused) {
  const Model model = tests::sheet_model();
  Channel channel{ChannelTarget::weights, 0, Interpolation::linear, {}, {}};
  for (std::size_t k = 0; k <= k_most_opened_moments; ++k) {
    channel.times_s.push_back(static_cast<double>(k) * 0.01);
    channel.values.insert(channel.values.end(), {0.5, k % 2 == 0 ? 0.0 : 1.0});
  }
  const auto keys = keys_of(model, {"long", {channel}});
  ASSERT_FALSE(keys.ok());
  EXPECT_EQ(keys.error().remedy, "cut it into shorter ones");
}

}  // namespace
}  // namespace penpose::document
