#include "core/document/time/head_joints.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/geometry/rotation.h"
#include "tests/support/models/model_samples.h"

namespace penpose::document {
namespace {

/// Two squares: one that a joint far up carries and whose corner a shape moves, and a body that hangs on the root.
Model figure(const std::vector<std::string>& names, std::size_t face_joint) {
  mesh::MeshSource source;
  tests::add_square(source, "face", 0);
  tests::add_square(source, "body", 5);
  rig::BlendShape shape;
  shape.parameter.name = "up";
  shape.vertices = {0, 1};
  shape.deltas = {{0, 0.5F, 0}, {0, 0.5F, 0}};
  const auto mesh = mesh::TriangleMesh::build(std::move(source)).value();
  std::vector<rig::Joint> joints;
  for (std::size_t j = 0; j < names.size(); ++j) {
    rig::Joint& joint = joints.emplace_back();
    joint.name = names[j];
    joint.parent = static_cast<std::int32_t>(j) - 1;
    joint.translation = {0, 1, 0};
    joint.rest_rotation = geometry::quaternion_from_xyz({0.3 * static_cast<double>(j), 0.1, 0});
  }
  std::vector<std::uint32_t> first{0};
  std::vector<rig::Influence> influences;
  for (std::uint32_t v = 0; v < mesh->vertex_count(); ++v) {
    influences.push_back({static_cast<std::uint32_t>(2 * v < mesh->vertex_count() ? face_joint : 0), 1});
    first.push_back(v + 1);
  }
  auto skeleton = rig::Skeleton::make(std::move(joints), std::move(first), std::move(influences)).value();
  auto shapes = rig::BlendShapes::make({shape}, mesh->vertex_count()).value();
  return make_model(mesh, shapes, skeleton).value();
}

TEST(HeadJoints, AreKnownByTheNamesOfManyRigs) {
  for (const char* head :
       {"Head", "mixamorig:Head", "J_Bip_C_Head", "Bip01 Head", "CC_Base_Head", "head_01", "DEF-head", "頭"}) {
    const auto found = head_joints(figure({"Hips", "Neck", head, "HeadTop_End"}, 2));
    ASSERT_TRUE(found) << head;
    EXPECT_EQ(found->head, 2U) << head;
    EXPECT_EQ(found->necks, std::vector<std::uint32_t>{1}) << head;
  }
  const auto two = head_joints(figure({"pelvis", "neck_01", "neck_02", "head"}, 3));
  EXPECT_EQ(two->necks, (std::vector<std::uint32_t>{1, 2}));
}

TEST(HeadJoints, AreThoseOfTheHumanoidWhereTheFileSaysThem) {
  Model model = figure({"bone", "Head", "bone.002", "bone.003"}, 3);
  model.humanoid.joint_of[static_cast<std::size_t>(HumanBone::head)] = 3;
  model.humanoid.joint_of[static_cast<std::size_t>(HumanBone::neck)] = 2;
  const auto found = head_joints(model);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->head, 3U) << "not the one that is called so";
  EXPECT_EQ(found->necks, std::vector<std::uint32_t>{2});
  model.humanoid.joint_of[static_cast<std::size_t>(HumanBone::head)] = 40;
  EXPECT_EQ(head_joints(model)->head, 1U) << "a table of another skeleton says nothing";
}

TEST(HeadJoints, AreElseFoundByWhatCarriesTheFace) {
  const auto found = head_joints(figure({"bone", "bone.001", "bone.002", "bone.003"}, 2));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->head, 2U);
  EXPECT_TRUE(found->necks.empty());
  EXPECT_FALSE(head_joints(figure({"head", "hair"}, 0))) << "a head alone moves as a whole";
  EXPECT_FALSE(head_joints(figure({"bone", "bone.001"}, 0)));
}

TEST(HeadJoints, TheHeadComesToStandAsThePlacementSays) {
  Model model = figure({"Hips", "Neck", "Head"}, 2);
  const std::vector<double> times{0, 1};
  const glm::dquat turn = geometry::quaternion_from_xyz({0.2, 0.6, -0.1});
  const std::vector<Placement> placements{{}, {turn, {1, 0, 0}, 2}};
  model.animations = {make_animation(model, "clip", times, std::vector<rig::Pose>(2, model.pose))};
  const HeadJoints joints = head_joints(model).value();
  model = with_head_turns(std::move(model), 0, joints, times, placements);
  for (const Channel& channel : model.animations[0].channels) {
    if (channel.target == ChannelTarget::weights) continue;
    EXPECT_EQ(channel.target, ChannelTarget::rotation);
    EXPECT_NE(channel.joint, 0U) << "the body stands";
  }
  const auto moment = sample(model, model.animations[0], 1);
  const glm::dquat head = turn_from_rest(model, 2, moment.joints);
  const glm::dquat neck = turn_from_rest(model, 1, moment.joints);
  EXPECT_NEAR(std::abs(glm::dot(head, turn)), 1, 1e-9);
  EXPECT_NEAR(std::abs(glm::dot(neck * neck, turn)), 1, 1e-9) << "the neck takes half of it";
  const auto rest = sample(model, model.animations[0], 0);
  EXPECT_NEAR(std::abs(turn_from_rest(model, 2, rest.joints).w), 1, 1e-9);
}

}  // namespace
}  // namespace penpose::document
