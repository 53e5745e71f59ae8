#include "core/document/expressions.h"

#include <gtest/gtest.h>

#include "core/document/humanoid.h"
#include "tests/support/models/gltf_sample.h"

namespace penpose::document {
namespace {

Model two_expressions() {
  Model model = tests::morph_sample().read().value();
  model.expressions = {{"Blink_L", {{0, 1.0}}}, {"Joy", {{0, 3.0}}}};
  return model;
}

TEST(Expressions, AreFoundByTheNamesOfBothVersions) {
  const Model model = two_expressions();
  EXPECT_EQ(expression_named(model, "blinkLeft"), 0U);
  EXPECT_EQ(expression_named(model, "happy"), 1U);
  EXPECT_EQ(expression_named(model, "joy"), 1U);
  EXPECT_FALSE(expression_named(model, "sad"));
  EXPECT_FALSE(expression_named(model, ""));
  EXPECT_EQ(preset_of("Blink_L"), "blinkLeft");
  EXPECT_EQ(preset_of("wink"), "");
}

TEST(Expressions, SetTheirTargetsWithinTheirRanges) {
  const Model model = two_expressions();
  rig::Pose pose = model.pose;
  set_expression(model, model.expressions[1], 0.25, pose);
  EXPECT_EQ(pose[0], 0.75);
  set_expression(model, model.expressions[1], 1, pose);
  EXPECT_EQ(pose[0], 1) << "the target ends at 1";
}

TEST(Expressions, StayWithTheirTargetsWhenControlsAreAdded) {
  const Model model = two_expressions();
  std::vector<rig::BlendShape> shapes{model.shapes->shapes()[0], model.shapes->shapes()[0]};
  shapes[0].parameter.name = "new";
  auto more = rig::BlendShapes::make(shapes, model.mesh->vertex_count()).value();
  const Model after = with_controls(model, more, {}).value();
  ASSERT_EQ(after.expressions.size(), 2U);
  EXPECT_EQ(after.expressions[0].values[0].first, 1U);
}

TEST(Humanoid, IsKnownByTheNamesThatProgramsGive) {
  const std::vector<std::pair<const char*, HumanBone>> known{{"J_Bip_C_Head", HumanBone::head},
                                                             {"J_Bip_L_UpperArm", HumanBone::left_upper_arm},
                                                             {"J_Adj_R_FaceEye", HumanBone::right_eye},
                                                             {"mixamorig:LeftUpLeg", HumanBone::left_upper_leg},
                                                             {"LeftForeArm", HumanBone::left_lower_arm},
                                                             {"RightHandThumb1", HumanBone::right_thumb_metacarpal},
                                                             {"upper_arm.L", HumanBone::left_upper_arm},
                                                             {"Bip01 R Hand", HumanBone::right_hand},
                                                             {"Jaw", HumanBone::jaw},
                                                             {"rightIndexProximal", HumanBone::right_index_proximal},
                                                             {"Hips", HumanBone::hips}};
  std::vector<rig::Joint> joints;
  for (const auto& [name, bone] : known) {
    joints.emplace_back().name = name;
    const Humanoid found = humanoid_by_names(std::span(joints).last(1));
    EXPECT_EQ(found.joint(bone), 0U) << name;
  }
  for (const char* name : {"hair_01_L", "HeadTop_End", "joint3", "LeftRightArm", "headlight"}) {
    rig::Joint joint;
    joint.name = name;
    EXPECT_TRUE(humanoid_by_names(std::span(&joint, 1)).empty()) << name;
  }
}

TEST(Humanoid, NamesAndParentsAreThoseOfTheSpecification) {
  EXPECT_EQ(name_of(HumanBone::left_thumb_metacarpal), "leftThumbMetacarpal");
  EXPECT_EQ(human_bone_named_in_vrm0("leftThumbProximal"), HumanBone::left_thumb_metacarpal);
  EXPECT_EQ(human_bone_named_in_vrm0("leftThumbDistal"), HumanBone::left_thumb_distal);
  EXPECT_EQ(parent_of(HumanBone::left_upper_arm), HumanBone::left_shoulder);
  EXPECT_EQ(parent_of(HumanBone::hips), std::nullopt);
  for (std::size_t b = 1; b < k_human_bones; ++b) {
    EXPECT_LT(*parent_of(static_cast<HumanBone>(b)), static_cast<HumanBone>(b));
  }
}

}  // namespace
}  // namespace penpose::document
