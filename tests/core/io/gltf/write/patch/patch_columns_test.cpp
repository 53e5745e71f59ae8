#include "core/io/gltf/write/patch/patch_columns.h"

#include <gtest/gtest.h>

#include "core/io/project/read_document.h"
#include "core/io/project/write_document.h"
#include "tests/support/file_parts.h"
#include "tests/support/models/textured_trunk.h"

namespace penpose::io {
namespace {

using SharedBytes = std::vector<std::uint8_t>;
using SharedJson = nlohmann::json;

std::size_t count_of(const SharedJson& json, const SharedJson& channel, std::size_t animation) {
  const SharedJson& sampler = json["animations"][animation]["samplers"][channel["sampler"].get<std::size_t>()];
  return json["accessors"][sampler["output"].get<std::size_t>()]["count"];
}

TEST(SharedMesh, ANodeThatNeedsAnotherTargetGetsACopyAndTheOtherKeepsItsMesh) {
  const SharedBytes bytes = tests::twin_trunks().glb();
  document::Model model = tests::with_curl(tests::read_glb(bytes));
  model.pose[1] = 0.5;
  WriteReport report;
  const SharedBytes written = write_glb(model, {}, &report).value();
  EXPECT_TRUE(report.notes.empty()) << report.notes.front();
  tests::expect_kept(bytes, written, {"/nodes/1/mesh", "/animations"});
  const SharedJson json = tests::parts_of(written).json;
  EXPECT_EQ(json["meshes"][0], tests::parts_of(bytes).json["meshes"][0]);
  ASSERT_EQ(json["meshes"].size(), 2U);
  EXPECT_EQ(json["nodes"][1]["mesh"], 1);
  EXPECT_EQ(json["nodes"][3]["mesh"], 0);
  const SharedJson& copy = json["meshes"][1];
  const SharedJson& primitive = copy["primitives"][0];
  EXPECT_EQ(primitive["attributes"], json["meshes"][0]["primitives"][0]["attributes"]) << "nothing is there twice";
  EXPECT_EQ(primitive["extensions"], json["meshes"][0]["primitives"][0]["extensions"]);
  EXPECT_EQ(primitive["targets"][0], json["meshes"][0]["primitives"][0]["targets"][0]);
  const std::size_t targets = primitive["targets"].size();
  ASSERT_GE(targets, 2U);
  EXPECT_EQ(copy["extras"]["targetNames"][1], "curl");
  EXPECT_EQ(copy["extras"]["acme"], "mine");
  EXPECT_EQ(copy["weights"].size(), targets);
  EXPECT_EQ(copy["weights"][1], 0.5);
  // A sampler that moved both: each node has as many weights as its mesh has targets.
  const SharedJson& channels = json["animations"][0]["channels"];
  EXPECT_EQ(count_of(json, channels[0], 0), 2 * targets);
  EXPECT_EQ(count_of(json, channels[2], 0), 2U);
}

TEST(SharedMesh, ItReadsBackAsItWasAndGoesOnBeingTheFile) {
  document::Model model = tests::with_curl(tests::read_glb(tests::twin_trunks().glb()));
  model.pose[1] = 0.5;
  const SharedBytes written = write_glb(model).value();
  const document::Model again = tests::read_glb(written);
  EXPECT_EQ(document::state_hash(again), document::state_hash(model));
  EXPECT_EQ(write_glb(again).value(), written);
  const document::Model without = document::with_deformers(again, nullptr).value();
  const SharedBytes back = write_glb(without).value();
  const SharedJson json = tests::parts_of(back).json;
  EXPECT_EQ(json["meshes"].size(), 2U) << "its own mesh is no shared one any more";
  EXPECT_EQ(json["meshes"][1]["extras"]["targetNames"], SharedJson({"lift"}));
  EXPECT_EQ(document::state_hash(tests::read_glb(back)), document::state_hash(without));
}

TEST(SharedMesh, TheFirstOfThreeKeepsItsPlaceInAProject) {
  tests::GltfSample sample = tests::twin_trunks();
  sample.add("nodes", {{"name", "third"}, {"mesh", 0}, {"translation", {0, 50, 0}}});
  sample.json["nodes"][0]["children"].push_back(4);
  document::Document document = document::make_document(tests::with_curl(sample.read().value()));
  const auto parts = document.model->mesh->parts();
  const auto again = read_document(write_project(document).value(), "a.glb");
  ASSERT_TRUE(again) << again.error().line();
  ASSERT_EQ(again->model->mesh->parts().size(), parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) EXPECT_EQ(again->model->mesh->parts()[i].name, parts[i].name);
  EXPECT_EQ(document::state_hash(*again->model), document::state_hash(*document.model));
}

TEST(SharedMesh, TargetsWithoutNamesStayThoseOfTheirNode) {
  tests::GltfSample sample = tests::twin_trunks();
  sample.json["meshes"][0]["extras"].erase("targetNames");
  sample.json.erase("animations");  // weights that a clip does not move are those of the pose
  document::Model model = tests::with_curl(sample.read().value());
  ASSERT_EQ(model.shapes->shapes().size(), 2U) << "each node has a control of its own";
  model.pose[0] = 0.25;
  model.pose[1] = 0.75;
  const document::Model again = tests::read_glb(write_glb(model).value());
  EXPECT_EQ(again.pose, model.pose);
  EXPECT_EQ(document::state_hash(again), document::state_hash(model));
}

TEST(PatchAnimations, WhatAnExtensionDrivesStaysWhereAnAnimationIsWrittenAgain) {
  tests::GltfSample sample = tests::textured_trunk();
  auto& channels = sample.json["animations"][1]["channels"];
  const SharedJson driven = {
      {"sampler", 1},
      {"target", {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", "/cameras/0/x"}}}}}}}};
  channels.insert(channels.begin(), driven);
  const auto look = sample.json["animations"][1]["samplers"][1]["output"];
  sample.json["extensionsUsed"].push_back("KHR_animation_pointer");
  document::Model model = sample.read().value();
  model.animations[1].channels[0].values = {0.5, 1};
  const SharedJson clip = tests::parts_of(write_glb(model).value()).json["animations"][1];
  const auto found = std::find_if(clip["channels"].begin(), clip["channels"].end(),
                                  [](const SharedJson& one) { return one["target"]["path"] == "pointer"; });
  ASSERT_NE(found, clip["channels"].end());
  EXPECT_EQ((*found)["target"], driven["target"]);
  EXPECT_EQ(clip["samplers"][(*found)["sampler"].get<std::size_t>()]["output"], look);
}

}  // namespace
}  // namespace penpose::io
