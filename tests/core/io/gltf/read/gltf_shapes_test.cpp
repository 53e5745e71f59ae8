#include "core/io/gltf/read/internal/gltf_shapes.h"

#include <gtest/gtest.h>
#include <limits>

#include "tests/support/models/gltf_sample.h"

namespace penpose::io {
namespace {

TEST(GltfShapes, SparseTargetWithoutABase) {
  const auto model = tests::morph_sample().read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  ASSERT_EQ(model->shapes->shapes().size(), 1U);
  const auto& shape = model->shapes->shapes()[0];
  EXPECT_EQ(shape.parameter, (rig::Parameter{"lift", 0, 0, 1}));
  EXPECT_EQ(shape.vertices, std::vector<std::uint32_t>{2});
  EXPECT_EQ(model->pose, rig::Pose{0.25});
  EXPECT_EQ(document::posed_positions(*model)[2], geometry::ModelPoint(1, 1, 0.125));
}

TEST(GltfShapes, DenseSparseOnABaseAndEmptyTargets) {
  tests::GltfSample sample = tests::morph_sample();
  auto& primitive = sample.json["meshes"][0]["primitives"][0];
  const auto dense = sample.add_vec3({0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 2});
  nlohmann::json based = sample.json["accessors"][2];
  based["bufferView"] = sample.json["accessors"][dense]["bufferView"];
  const auto on_base = sample.add("accessors", based);
  const auto zeros = sample.add("accessors", {{"componentType", 5126}, {"count", 4}, {"type", "VEC3"}});
  primitive["targets"] = {
      {{"POSITION", dense}}, {{"POSITION", on_base}}, {{"POSITION", zeros}}, nlohmann::json::object()};
  sample.json["meshes"][0].erase("extras");
  const auto model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  const auto shapes = model->shapes->shapes();
  ASSERT_EQ(shapes.size(), 4U);
  EXPECT_EQ(shapes[0].parameter.name, "square.target0");
  EXPECT_EQ(shapes[0].vertices, (std::vector<std::uint32_t>{1, 3}));
  EXPECT_EQ(shapes[1].vertices, (std::vector<std::uint32_t>{1, 2, 3}));
  EXPECT_TRUE(shapes[2].vertices.empty());
  EXPECT_TRUE(shapes[3].vertices.empty());
}

TEST(GltfShapes, NormalDeltasAreKept) {
  tests::GltfSample sample = tests::morph_sample();
  sample.json["meshes"][0]["primitives"][0]["targets"][0]["NORMAL"] =
      sample.add_vec3({0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  const auto model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  const auto& shape = model->shapes->shapes()[0];
  EXPECT_EQ(shape.vertices, (std::vector<std::uint32_t>{0, 2}));
  EXPECT_EQ(shape.normal_deltas[0], glm::vec3(0, 1, 0));
  EXPECT_EQ(shape.deltas[1], glm::vec3(0, 0, 0.5F));
}

TEST(GltfShapes, TargetsOfOneNameAreOneShapeAcrossMeshes) {
  tests::GltfSample sample = tests::morph_sample();
  nlohmann::json second = sample.json["meshes"][0];
  second["name"] = "second";
  second["weights"] = {0.75};
  sample.add("meshes", second);
  sample.add("nodes", {{"mesh", 1}});
  sample.json["scenes"][0]["nodes"] = {0, 1};
  const auto model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  ASSERT_EQ(model->shapes->shapes().size(), 1U);
  EXPECT_EQ(model->shapes->shapes()[0].vertices, (std::vector<std::uint32_t>{2, 6}));
  EXPECT_EQ(model->pose, rig::Pose{0.25});
  EXPECT_EQ(model->notes.size(), 1U);
}

TEST(GltfShapes, WeightsOutsideTheRangeExtendIt) {
  tests::GltfSample sample = tests::morph_sample();
  sample.json["meshes"][0]["weights"] = {-0.5};
  auto model = sample.read();
  ASSERT_TRUE(model.ok());
  EXPECT_EQ(model->shapes->parameters()[0].minimum, -0.5);
  sample.json["nodes"][0]["weights"] = {3};  // the node's weights go before the mesh's
  model = sample.read();
  ASSERT_TRUE(model.ok());
  EXPECT_EQ(model->shapes->parameters()[0].maximum, 3);
  EXPECT_EQ(model->pose, rig::Pose{3});
}

TEST(GltfShapes, NamesMayStandInThePrimitive) {
  // VRM 0.x keeps them there; those of the mesh count before them.
  tests::GltfSample sample = tests::morph_sample();
  auto& mesh = sample.json["meshes"][0];
  mesh.erase("extras");
  mesh["primitives"][0]["extras"]["targetNames"] = {"up"};
  EXPECT_EQ(sample.read().value().shapes->parameters()[0].name, "up");
  mesh["extras"]["targetNames"] = {"lift"};
  EXPECT_EQ(sample.read().value().shapes->parameters()[0].name, "lift");
}

TEST(GltfShapes, OddNamesAndFaults) {
  tests::GltfSample sample = tests::morph_sample();
  auto& mesh = sample.json["meshes"][0];
  mesh["primitives"][0]["targets"].push_back({{"POSITION", 2}});
  mesh["primitives"][0]["targets"].push_back({{"POSITION", 2}});
  mesh["extras"]["targetNames"] = {"a", "a", 5};
  auto model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_EQ(model->shapes->parameters()[1].name, "a.2");
  EXPECT_EQ(model->shapes->parameters()[2].name, "square.target2");
  mesh["extras"] = "none";
  EXPECT_TRUE(sample.read().ok());
  mesh["weights"] = {1e300};
  EXPECT_EQ(sample.error().place, "/meshes/0/weights");
  mesh["weights"] = {0};
  mesh["primitives"][0]["targets"][0]["POSITION"] = sample.add_vec3({0, 0, 0});
  EXPECT_EQ(sample.error().place, "/accessors/3/count");
  mesh["primitives"][0]["targets"][0]["POSITION"] =
      sample.add_vec3({0, 0, 0, 0, 0, 0, 0, 0, std::numeric_limits<float>::quiet_NaN(), 0, 0, 0});
  EXPECT_EQ(sample.error().place, "target square.target0");
}

}  // namespace
}  // namespace penpose::io
