#include "core/io/gltf/read/internal/gltf_skins.h"

#include <gtest/gtest.h>
#include <limits>

#include "tests/support/models/gltf_sample.h"

namespace penpose::io {
namespace {

std::string accessor_pointer_of(const nlohmann::json& index) { return "/accessors/" + index.dump(); }

TEST(GltfSkins, JointsCarryTheVerticesAndTheMeshNodeDoesNot) {
  const auto model = tests::skin_sample().read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  ASSERT_EQ(model->skeleton->joints().size(), 2U);
  EXPECT_EQ(model->rig->parameters()[3].name, "tip.rx");
  EXPECT_EQ(document::posed_positions(*model)[2], geometry::ModelPoint(1, 1, 0));
  EXPECT_EQ(model->skeleton->influences_of(1).size(), 2U);
  EXPECT_EQ(model->skeleton->influences_of(0).size(), 1U);
}

TEST(GltfSkins, ParentsComeFirstWhateverTheOrderOfTheNodes) {
  tests::GltfSample sample = tests::skin_sample();
  auto& nodes = sample.json["nodes"];
  nodes.push_back({{"name", "above"}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 7, 1}}, {"children", {1}}});
  sample.json["scenes"][0]["nodes"] = {0, 3};
  const auto model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  const auto joints = model->skeleton->joints();
  ASSERT_EQ(joints.size(), 3U);
  EXPECT_EQ(joints[0].name, "above");
  EXPECT_FALSE(joints[0].posable);
  EXPECT_EQ(joints[2].parent, 1);
  EXPECT_EQ(document::posed_positions(*model)[0], geometry::ModelPoint(0, 0, 7));
}

TEST(GltfSkins, RigidPartsGoWithTheirNodes) {
  tests::GltfSample sample = tests::square_sample();
  sample.add("meshes", sample.json["meshes"][0]);
  sample.add("nodes", {{"name", "eye"}, {"mesh", 1}, {"translation", {0, 0, 3}}});
  sample.json["nodes"][0]["children"] = {1};
  const auto model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  ASSERT_EQ(model->rig->parameters().size(), 3U);
  EXPECT_EQ(model->rig->parameters()[0].name, "eye.rx");
  EXPECT_TRUE(model->skeleton->influences_of(0).empty());
  EXPECT_EQ(model->skeleton->influences_of(4).size(), 1U);
  EXPECT_EQ(document::posed_positions(*model)[4], geometry::ModelPoint(0, 0, 3));
}

TEST(GltfSkins, ASingleMovedMeshIsCarriedButNotPosable) {
  tests::GltfSample sample = tests::square_sample();
  sample.json["nodes"][0]["scale"] = {100, 100, 100};
  const auto model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_TRUE(model->rig->parameters().empty());
  EXPECT_EQ(document::posed_positions(*model)[1], geometry::ModelPoint(100, 0, 0));
}

TEST(GltfSkins, ANodeWithSeveralBindMatricesGetsJointsForThem) {
  tests::GltfSample sample = tests::skin_sample();
  nlohmann::json second = sample.json["meshes"][0];
  second["name"] = "second";
  sample.add("meshes", second);
  std::vector<float> binds(16, 0.0F);
  for (std::size_t i = 0; i < 4; ++i) binds[5 * i] = 1;
  binds[12] = -7;
  sample.add("skins", {{"joints", {1, 2}},
                       {"inverseBindMatrices", sample.add_accessor(std::vector<float>(binds), "MAT4", 16, 5126)}});
  sample.json["skins"][1]["joints"] = {1};
  sample.add("nodes", {{"mesh", 1}, {"skin", 1}});
  sample.json["scenes"][0]["nodes"] = {0, 1, 3};
  sample.json["meshes"][1]["primitives"][0]["attributes"]["JOINTS_0"] =
      sample.add_accessor(std::vector<std::uint8_t>(16, 0), "VEC4", 4, 5121);
  const auto model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  ASSERT_EQ(model->skeleton->joints().size(), 3U);
  EXPECT_EQ(model->skeleton->joints()[2].parent, 0);
  EXPECT_FALSE(model->skeleton->joints()[2].posable);
  EXPECT_EQ(document::posed_positions(*model)[4], geometry::ModelPoint(-5, 0, 0));
}

TEST(GltfSkins, WeightsAreMadeToSumToOne) {
  tests::GltfSample sample = tests::skin_sample();
  auto& attributes = sample.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["WEIGHTS_0"] =
      sample.add_accessor(std::vector<float>{3, 0, 0, 0, 1, 2, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0}, "VEC4", 4, 5126);
  const auto model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_EQ(model->skeleton->influences_of(0)[0].weight, 1.0);
  EXPECT_NEAR(model->skeleton->influences_of(1)[1].weight, 2.0 / 3, 1e-7);
  EXPECT_EQ(model->skeleton->influences_of(2)[0].joint, 0U);
  EXPECT_EQ(model->notes.size(), 1U);
}

TEST(GltfSkins, WeightsThatMeanNothingAreLeftOutWithANote) {
  tests::GltfSample sample = tests::skin_sample();
  auto& attributes = sample.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_0"] =
      sample.add_accessor(std::vector<std::uint8_t>{0, 1, 0, 0, 1, 0, 0, 0, 1, 9, 0, 0, 9, 0, 0, 0}, "VEC4", 4, 5121);
  attributes["WEIGHTS_0"] =
      sample.add_accessor(std::vector<float>{1, -0.01F, 0, 0, 1, std::numeric_limits<float>::quiet_NaN(), 0, 0, 0.5F,
                                             0.5F, 0, 0, 1, 0, 0, 0},
                          "VEC4", 4, 5126);
  const auto model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  const std::vector<std::uint32_t> joints = {0, 1, 1, 0};
  for (std::uint32_t v = 0; v < joints.size(); ++v) {
    ASSERT_EQ(model->skeleton->influences_of(v).size(), 1U) << v;
    EXPECT_EQ(model->skeleton->influences_of(v)[0].joint, joints[v]) << v;
    EXPECT_EQ(model->skeleton->influences_of(v)[0].weight, 1.0) << v;
  }
  ASSERT_EQ(model->notes.size(), 2U) << "one vertex is left with no weight at all";
  EXPECT_NE(model->notes[1].find("left out: 4"), std::string::npos) << model->notes[1];
}

TEST(GltfSkins, NamelessAndRepeatedJointsGetNames) {
  tests::GltfSample sample = tests::skin_sample();
  sample.json["nodes"][1]["name"] = "tip";
  auto model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_EQ(model->rig->parameters()[3].name, "tip.2.rx");
  sample.json["nodes"][1].erase("name");
  model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_EQ(model->rig->parameters()[0].name, "joint0.rx");
}

TEST(GltfSkins, FaultsAreNamed) {
  tests::GltfSample sample = tests::skin_sample();
  sample.json["skins"][0]["inverseBindMatrices"] = sample.add_accessor(std::vector<float>(16, 0), "MAT4", 16, 5126);
  EXPECT_EQ(sample.error().place, "/skins/0");
  std::vector<float> binds(32, 0.0F);
  binds[3] = 5;  // the last row does not count
  binds[0] = std::numeric_limits<float>::infinity();
  sample.json["skins"][0]["inverseBindMatrices"] = sample.add_accessor(binds, "MAT4", 16, 5126);
  EXPECT_EQ(sample.error().place, accessor_pointer_of(sample.json["skins"][0]["inverseBindMatrices"]));
  sample.json["skins"][0]["joints"] = nlohmann::json::array();
  EXPECT_EQ(sample.error().place, "/skins/0");
}

}  // namespace
}  // namespace penpose::io
