#include "core/io/gltf/write/patch/patch_joints.h"

#include <gtest/gtest.h>

#include "core/document/time/animation_building.h"
#include "tests/support/file_parts.h"
#include "tests/support/models/textured_trunk.h"

namespace penpose::io {
namespace {

using CarrierJson = nlohmann::json;

/// The trunk and a ball that a node carries, below the same root.
tests::GltfSample face_and_ball(std::size_t parent_of_ball) {
  tests::GltfSample sample = tests::textured_trunk();
  CarrierJson ball = sample.json["meshes"][0];
  ball["name"] = "ball";
  ball["primitives"][0].erase("targets");
  ball.erase("extras");
  ball.erase("weights");
  sample.json["meshes"].push_back(ball);
  sample.add("nodes", {{"name", "ball"}, {"mesh", 1}, {"translation", {50, 0, 0}}});
  sample.json["nodes"][parent_of_ball]["children"].push_back(3);
  return sample;
}

document::Model tracked(document::Model model) {
  const std::vector<double> times{0, 1};
  std::vector<rig::Pose> poses(2, model.pose);
  poses[1][0] = 0.5;
  model.animations.push_back(document::make_animation(model, "tracked", times, poses));
  const std::vector<document::Placement> placements{{}, {glm::dquat(0.8, 0, 0.6, 0), {0.1, 0, 0}, 1.2}};
  const std::size_t last = model.animations.size() - 1;
  return document::with_placements(std::move(model), last, {0, 0, 0}, times, placements).value();
}

TEST(PatchJoints, AFaceBesideCarriedPartsGetsACarrierOfItsOwn) {
  const auto bytes = face_and_ball(0).glb();
  const document::Model model = tracked(tests::read_glb(bytes));
  WriteReport report;
  const auto written = write_glb(model, {}, &report).value();
  EXPECT_TRUE(report.notes.empty()) << report.notes.front();
  tests::expect_kept(bytes, written, {"/scenes/0/nodes", "/nodes/0/children"});
  const CarrierJson json = tests::parts_of(written).json;
  EXPECT_EQ(json["nodes"][0]["children"], CarrierJson({2, 3}));
  EXPECT_EQ(json["nodes"][4]["children"], CarrierJson({1}));
  EXPECT_EQ(json["scenes"][0]["nodes"], CarrierJson({0, 4}));
  EXPECT_EQ(document::state_hash(tests::read_glb(written)), document::state_hash(model));
}

TEST(PatchJoints, AFaceOnWhichOthersHangGivesItsMeshToAnotherNode) {
  const auto bytes = face_and_ball(1).glb();
  document::Model model = tracked(tests::with_curl(tests::read_glb(bytes)));
  model.pose[1] = 0.25;
  WriteReport report;
  const auto written = write_glb(model, {}, &report).value();
  EXPECT_TRUE(report.notes.empty()) << report.notes.front();
  const CarrierJson json = tests::parts_of(written).json;
  EXPECT_TRUE(json.contains("textures"));
  EXPECT_FALSE(json["nodes"][1].contains("mesh"));
  EXPECT_EQ(json["nodes"][1]["children"], CarrierJson({3}));
  EXPECT_EQ(json["nodes"][4]["mesh"], 0);
  EXPECT_EQ(json["animations"][0]["channels"][0]["target"]["node"], 4) << "its clip moves it still";
  const document::Model again = tests::read_glb(written);
  EXPECT_EQ(document::state_hash(again), document::state_hash(model));
}

}  // namespace
}  // namespace penpose::io
