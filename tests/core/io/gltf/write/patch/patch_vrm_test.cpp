#include "core/io/gltf/write/patch/patch_vrm.h"

#include <gtest/gtest.h>

#include "core/io/project/read_document.h"
#include "core/io/project/write_document.h"
#include "tests/support/file_parts.h"
#include "tests/support/models/figure_sample.h"
#include "tests/support/models/textured_trunk.h"
#include "tests/support/models/whole_avatar.h"

namespace penpose::io {
namespace {

using VrmJson = nlohmann::json;
using document::HumanBone;

VrmJson json_of(const document::Model& model) { return tests::parts_of(write_glb(model).value()).json; }

/// The trunk as an avatar of VRM 0.x with an expression of its target.
tests::GltfSample old_avatar() {
  tests::GltfSample sample = tests::textured_trunk();
  sample.json["extensionsUsed"].push_back("VRM");
  sample.json["extensions"]["VRM"] = {
      {"specVersion", "0.0"},
      {"firstPerson", {{"meshAnnotations", {{{"mesh", 0}, {"firstPersonFlag", "Auto"}}}}}},
      {"blendShapeMaster",
       {{"blendShapeGroups", {{{"name", "A"}, {"binds", {{{"mesh", 0}, {"index", 0}, {"weight", 60}}}}}}}}}};
  return sample;
}

TEST(PatchVrm, ACopyOfAMeshIsBoundAsTheMeshIs) {
  tests::GltfSample sample = old_avatar();
  sample.add("nodes", {{"name", "twin"}, {"mesh", 0}, {"translation", {50, 0, 0}}});
  sample.json["nodes"][0]["children"] = {1, 2, 3};
  const document::Model model = tests::with_curl(sample.read().value());
  const VrmJson json = json_of(model);
  const VrmJson& vrm = json["extensions"]["VRM"];
  EXPECT_EQ(vrm["blendShapeMaster"]["blendShapeGroups"][0]["binds"],
            VrmJson({{{"mesh", 0}, {"index", 0}, {"weight", 60}}, {{"mesh", 1}, {"index", 0}, {"weight", 60}}}));
  EXPECT_EQ(vrm["firstPerson"]["meshAnnotations"],
            VrmJson({{{"mesh", 0}, {"firstPersonFlag", "Auto"}}, {{"mesh", 1}, {"firstPersonFlag", "Auto"}}}));
  const document::Model again = tests::read_glb(write_glb(model).value());
  ASSERT_EQ(again.expressions.size(), 1U);
  EXPECT_EQ(again.expressions[0].values, model.expressions[0].values);
}

TEST(PatchVrm, BindsFollowTheirTargetsAndGoWithThem) {
  tests::GltfSample sample = tests::textured_trunk();
  auto& mesh = sample.json["meshes"][0];
  mesh["primitives"][0]["targets"].push_back(mesh["primitives"][0]["targets"][0]);
  mesh["extras"]["targetNames"] = {"lift", "drop"};
  mesh["weights"] = {0, 0};
  sample.json.erase("animations");
  const VrmJson first = {{"node", 1}, {"index", 0}, {"weight", 1.0}};
  const VrmJson second = {{"node", 1}, {"index", 1}, {"weight", 0.5}};
  sample.json["extensions"]["VRMC_vrm"] = {{"specVersion", "1.0"},
                                           {"expressions",
                                            {{"preset", {{"happy", {{"morphTargetBinds", {first, second}}}}}},
                                             {"custom", {{"wink", {{"morphTargetBinds", {first}}}}}}}}};
  const document::Model model = sample.read().value();
  ASSERT_EQ(model.shapes->shapes().size(), 2U);
  const auto drop = rig::BlendShapes::make({model.shapes->shapes()[1]}, model.mesh->vertex_count()).value();
  const document::Model without = document::with_controls(model, drop, nullptr).value();
  const VrmJson expressions = json_of(without)["extensions"]["VRMC_vrm"]["expressions"];
  EXPECT_EQ(expressions["preset"]["happy"]["morphTargetBinds"],
            VrmJson({{{"node", 1}, {"index", 0}, {"weight", 0.5}}}));
  EXPECT_EQ(expressions["custom"]["wink"]["morphTargetBinds"], VrmJson::array());
}

TEST(PatchVrm, ASketchedControlIsNoPartOfAnExpression) {
  const document::Model model = tests::with_curl(old_avatar().read().value());
  const VrmJson vrm = json_of(model)["extensions"]["VRM"];
  EXPECT_EQ(vrm, old_avatar().json["extensions"]["VRM"]);
}

/// An avatar of the version with its head turned and its face lifted.
document::Model posed_avatar(int version) {
  tests::GltfSample sample = tests::avatar_sample(tests::turned_bones());
  if (version == 0) {
    VrmJson bones = VrmJson::array();
    for (const auto& [bone, of] : sample.json["extensions"]["VRMC_vrm"]["humanoid"]["humanBones"].items())
      bones.push_back({{"bone", bone}, {"node", of["node"]}});
    sample.json["extensions"] = {{"VRM", {{"humanoid", {{"humanBones", bones}}}}}};
    sample.json["extensionsUsed"] = {"VRM"};
  }
  document::Model model = sample.read().value();
  model.pose[0] = 0.5;
  for (std::size_t i = 1; i < model.pose.size(); ++i) model.pose[i] = 0.1 * static_cast<double>(i % 4);
  return model;
}

TEST(PatchVrm, APosedAvatarKeepsItsTPoseInTheFileAndItsPoseForPenpose) {
  for (const int version : {0, 1}) {
    const document::Model model = posed_avatar(version);
    WriteReport report;
    const auto written = write_glb(model, {}, &report).value();
    const VrmJson was = tests::parts_of(*model.source->bytes).json;
    const VrmJson now = tests::parts_of(written).json;
    ASSERT_EQ(now["nodes"].size(), was["nodes"].size());
    for (std::size_t n = 0; n < now["nodes"].size(); ++n) {
      VrmJson node = now["nodes"][n];
      node.erase("extras");
      EXPECT_EQ(node, was["nodes"][n]) << "node " << n << " of VRM " << version;
    }
    EXPECT_EQ(now["extensions"], was["extensions"]);
    EXPECT_EQ(now["meshes"][0]["weights"][0], 0.5) << "the face is seen in other programs";
    ASSERT_EQ(report.notes.size(), 1U);
    EXPECT_NE(report.notes[0].find("T-pose"), std::string::npos) << report.notes[0];
    const document::Model again = tests::read_glb(written);
    EXPECT_EQ(again.pose, model.pose);
    EXPECT_EQ(document::state_hash(again), document::state_hash(model));
    EXPECT_EQ(write_glb(again).value(), written);
  }
}

/// Binary expressions, what they override, spring bones, first person, look-at and metadata are not penpose's to
/// change.
TEST(PatchVrm, WhatAnAvatarSaysStaysWithADrawnControlAndAPose) {
  for (const int version : {0, 1}) {
    tests::GltfSample sample = tests::whole_avatar(version);
    document::Model model = tests::with_curl(sample.read().value());
    ASSERT_EQ(model.shapes->shapes().size(), 1U) << "expressions are no controls";
    EXPECT_FALSE(model.expressions.empty());
    for (double& value : model.pose) value = 0.25;
    const VrmJson json = json_of(model);
    EXPECT_EQ(json["extensions"], sample.json["extensions"]);
    EXPECT_EQ(json["extensionsUsed"], sample.json["extensionsUsed"]);
  }
}

TEST(PatchVrm, AnAvatarThatWasSavedInItsPoseIsPutBack) {
  document::Model model = posed_avatar(1);
  auto parts = tests::parts_of(write_glb(model).value());
  // As penpose wrote it once: the node has the pose.
  std::size_t head = 0;
  while (!parts.json["nodes"][head].contains("extras")) ++head;
  parts.json["nodes"][head]["rotation"] = {0.0, 0.0, 0.6, 0.8};
  const auto old = tests::GltfSample::glb_of(parts.json.dump(), parts.binary);
  document::Model read = tests::read_glb(old);
  EXPECT_EQ(read.pose, model.pose);
  EXPECT_EQ(write_glb(read).value(), old) << "without a change it stays what it is";
  read.pose[0] = 0.125;
  const VrmJson node = json_of(read)["nodes"][head];
  EXPECT_EQ(node["rotation"], node["extras"]["penpose"]["rest_rotation"]);
}

TEST(PatchVrm, ACharacterThatIsNoAvatarIsSeenPosedEverywhere) {
  tests::GltfSample sample = tests::skin_sample();
  document::Model model = sample.read().value();
  model.pose[5] = 0.5;
  WriteReport report;
  const VrmJson node = tests::parts_of(write_glb(model, {}, &report).value()).json["nodes"][2];
  EXPECT_TRUE(report.notes.empty());
  EXPECT_NEAR(node["rotation"][2].get<double>(), std::sin(0.25), 1e-9);
}

TEST(Humanoid, GoesWithTheModelThroughProjectsCommandsAndBareFiles) {
  const document::Model model = posed_avatar(1);
  const auto head = model.humanoid.joint(HumanBone::head);
  ASSERT_TRUE(head);
  EXPECT_EQ(model.skeleton->joints()[*head].name.substr(0, 5), "joint") << "its name says nothing";
  const auto same = [&](const document::Model& other) { return other.humanoid.joint_of == model.humanoid.joint_of; };
  const auto document = document::make_document(model);
  EXPECT_TRUE(same(*read_document(write_project(document).value(), "a.glb").value().model));
  EXPECT_TRUE(same(document::with_deformers(model, nullptr).value()));
  const auto bare = write_glb(model, {.bare = true}).value();
  EXPECT_FALSE(tests::parts_of(bare).json.contains("extensions"));
  EXPECT_TRUE(same(tests::read_glb(bare)));
  EXPECT_TRUE(same(tests::read_glb(write_glb(tests::read_glb(bare)).value())));
}

}  // namespace
}  // namespace penpose::io
