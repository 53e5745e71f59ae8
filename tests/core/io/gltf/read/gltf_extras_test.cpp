#include "core/io/gltf/internal/gltf_extras.h"

#include <gtest/gtest.h>

#include "core/base/edition.h"
#include "tests/support/models/gltf_sample.h"

namespace penpose::io {
namespace {

tests::GltfSample sample_with_extras() {
  tests::GltfSample sample = tests::skin_sample();
  sample.json["extras"]["penpose"] = {
      {"edition", base::k_edition},
      {"shapes", {{{"name", "lift"}, {"rest", 0}, {"minimum", -1}, {"maximum", 2}}}},
      {"curves", {{{"name", "brow"}, {"points", {{0, 0.5, 0.25, 0.25}, {1, 0, 0, 1}}}}}}};
  sample.json["nodes"][1]["extras"]["penpose"] = {
      {"joint", true},           {"posable", true},      {"rest_rotation", {0, 0, 0, 1}},
      {"minimum", {-1, -1, -1}}, {"maximum", {1, 1, 1}}, {"values", {0.5, -0.25, 7}}};
  return sample;
}

std::string place(const char* pointer, const nlohmann::json& value) {
  tests::GltfSample sample = sample_with_extras();
  sample.json[nlohmann::json::json_pointer(pointer)] = value;
  return sample.error().place;
}

TEST(GltfExtras, CurvesRangesAndJointValuesComeBack) {
  const auto model = sample_with_extras().read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  ASSERT_EQ(model->curves.size(), 1U);
  EXPECT_EQ(model->curves[0].points[1], (mesh::MeshPoint{1, {0, 0, 1}}));
  EXPECT_EQ(model->skeleton->joints()[0].maximum, glm::dvec3(1));
  EXPECT_EQ(model->pose, (rig::Pose{0.5, -0.25, 1, 0, 0, 0}));  // 7 lies outside the range
}

TEST(GltfExtras, FaultsAreNamed) {
  EXPECT_EQ(place("/extras/penpose/shapes", 2), "/extras/penpose/shapes");
  EXPECT_EQ(place("/extras/penpose/shapes/0/name", 2), "/extras/penpose/shapes/0");
  EXPECT_EQ(place("/extras/penpose/shapes/0/minimum", 3), "/extras/penpose/shapes/0");
  EXPECT_EQ(place("/extras/penpose/curves/0/name", 3), "/extras/penpose/curves/0");
  EXPECT_EQ(place("/extras/penpose/curves/0/points", 3), "/extras/penpose/curves/0");
  EXPECT_EQ(place("/extras/penpose/curves/0/points/0", {0, 1, 0}), "/extras/penpose/curves/0/points/0");
  EXPECT_EQ(place("/extras/penpose/curves/0/points/0", {2, 1, 0, 0}), "/extras/penpose/curves/0/points/0");
  EXPECT_EQ(place("/extras/penpose/curves/0/points/1", {0, 1, 1, 0}), "/extras/penpose/curves/0/points/1");
  EXPECT_EQ(place("/nodes/1/extras/penpose", 3), "/nodes/1/extras/penpose");
  EXPECT_EQ(place("/nodes/1/extras/penpose/joint", 3), "/nodes/1/extras/penpose/joint");
  EXPECT_EQ(place("/nodes/1/extras/penpose/values", {1, 2}), "/nodes/1/extras/penpose/values");
  EXPECT_EQ(place("/nodes/1/extras/penpose/rest_rotation", {0, 0, 0, 0}), "/nodes/1/extras/penpose/rest_rotation");
  EXPECT_EQ(place("/nodes/1/extras/penpose/minimum", {1, 1, 1}), "/nodes/1/extras");
  EXPECT_EQ(place("/nodes/1/extras/penpose/inverse_bind", {1, 1, 1}), "/nodes/1/extras/penpose/inverse_bind");
}

TEST(GltfExtras, ExtrasOfOthersAreNoneOfOurs) {
  tests::GltfSample sample = sample_with_extras();
  sample.json["extras"] = {{"penpoze", 5}};
  sample.json["nodes"][1]["extras"]["penpose"] = "whatever";  // means nothing without ours at the root
  EXPECT_TRUE(sample.read().ok());
}

}  // namespace
}  // namespace penpose::io
