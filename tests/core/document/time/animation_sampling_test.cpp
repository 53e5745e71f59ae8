#include "core/document/time/animation_sampling.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/base/math.h"

namespace penpose::document {
namespace {

Channel channel(ChannelTarget target, Interpolation interpolation, std::vector<double> times_s,
                std::vector<double> values) {
  Channel made;
  made.target = target;
  made.interpolation = interpolation;
  made.times_s = std::move(times_s);
  made.values = std::move(values);
  return made;
}

/// One triangle with two shapes, carried by one joint.
Model small_model() {
  mesh::MeshSource source;
  source.positions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 0}};
  source.triangles = {{0, 1, 2}};
  std::vector<rig::BlendShape> targets(2);
  targets[0].parameter.name = "up";
  targets[0].vertices = {0};
  targets[0].deltas = {{0, 0, 1}};
  targets[1].parameter.name = "side";
  targets[1].vertices = {1};
  targets[1].deltas = {{1, 0, 0}};
  auto shapes = rig::BlendShapes::make(targets, 3);
  rig::Joint root;
  root.name = "root";
  auto skeleton = rig::Skeleton::make({root}, {0, 1, 2, 3}, {{0, 1.0}, {0, 1.0}, {0, 1.0}});
  return make_model(mesh::TriangleMesh::build(source).value(), shapes.value(), skeleton.value()).value();
}

TEST(AnimationSampling, HoldsBeforeTheFirstAndAfterTheLastKey) {
  const auto c = channel(ChannelTarget::translation, Interpolation::linear, {1, 2}, {0, 0, 0, 2, 4, 6});
  EXPECT_EQ(sample_channel(c, 3, -5), (std::vector<double>{0, 0, 0}));
  EXPECT_EQ(sample_channel(c, 3, 1.5), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(sample_channel(c, 3, 9), (std::vector<double>{2, 4, 6}));
}

TEST(AnimationSampling, StepsJumpAtTheKey) {
  const auto c = channel(ChannelTarget::weights, Interpolation::step, {0, 1, 2}, {0.1, 0.5, 0.9});
  EXPECT_EQ(sample_channel(c, 1, 0.999)[0], 0.1);
  EXPECT_EQ(sample_channel(c, 1, 1)[0], 0.5);
  EXPECT_EQ(sample_channel(c, 1, 2)[0], 0.9);
}

TEST(AnimationSampling, CubicSplineFollowsItsTangents) {
  // Value t^2 over 0..2 s has tangents 0 and 4 a second; a cubic reproduces it exactly.
  const auto c = channel(ChannelTarget::weights, Interpolation::cubic_spline, {0, 2}, {0, 0, 0, 4, 4, 4});
  for (double t = 0; t <= 2; t += 0.25) EXPECT_NEAR(sample_channel(c, 1, t)[0], t * t, 1e-12) << t;
}

TEST(AnimationSampling, RotationsTurnEvenlyByTheShorterWay) {
  const double half = std::sqrt(0.5);
  // The second key is the same turn with the other sign, which a straight blend would take the long way round.
  const auto c = channel(ChannelTarget::rotation, Interpolation::linear, {0, 1}, {0, 0, 0, 1, 0, 0, -half, -half});
  const auto third = sample_channel(c, 4, 1.0 / 3);
  EXPECT_NEAR(third[2], base::sin(base::radians(15)), 1e-12);
  EXPECT_NEAR(third[3], base::cos(base::radians(15)), 1e-12);
}

TEST(AnimationSampling, AChannelWithMissingValuesGivesNothing) {
  const auto c = channel(ChannelTarget::rotation, Interpolation::linear, {0, 1}, {0, 0, 0, 1});
  EXPECT_TRUE(sample_channel(c, 4, 0.5).empty());
  EXPECT_TRUE(sample_channel({}, 3, 0.5).empty());
}

TEST(AnimationSampling, WeightsAndJointsMoveTheModel) {
  Model model = small_model();
  Animation animation;
  animation.channels = {
      channel(ChannelTarget::weights, Interpolation::linear, {0, 1}, {0, 0, 1, 0.5}),
      channel(ChannelTarget::translation, Interpolation::linear, {0, 2}, {0, 0, 0, 10, 0, 0}),
  };
  EXPECT_EQ(duration_s(animation), 2);
  const auto moment = sample(model, animation, 1);
  EXPECT_EQ(moment.weights, (std::vector<double>{1, 0.5}));
  const Model posed = model_at(model, moment).value();
  const auto positions = posed_positions(posed);
  EXPECT_EQ(positions[0], geometry::ModelPoint(6, 0, 1));
  EXPECT_EQ(positions[1], geometry::ModelPoint(5.5, 1, 0));
  EXPECT_EQ(posed_positions(model)[0], geometry::ModelPoint(1, 0, 0)) << "the model itself stays as it was";
}

TEST(AnimationSampling, ChannelsOfJointsThatDoNotExistAreLeftOut) {
  Model model = small_model();
  Animation animation;
  auto stray = channel(ChannelTarget::translation, Interpolation::linear, {0}, {1, 1, 1});
  stray.joint = 7;
  animation.channels = {stray};
  EXPECT_EQ(posed_positions(model_at(model, sample(model, animation, 0)).value()), posed_positions(model));
}

}  // namespace
}  // namespace penpose::document
