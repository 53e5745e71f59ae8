#include "core/io/gltf/read/internal/gltf_meshes.h"

#include <gtest/gtest.h>
#include <limits>

#include "tests/support/models/gltf_sample.h"

namespace penpose::io {
namespace {

TEST(GltfMeshes, StripsAndFansBecomeTrianglesOfOneWinding) {
  for (const int mode : {5, 6}) {
    tests::GltfSample sample = tests::square_sample();
    auto& primitive = sample.json["meshes"][0]["primitives"][0];
    primitive["mode"] = mode;
    primitive["indices"] =
        sample.add_corners(mode == 5 ? std::vector<std::uint16_t>{0, 1, 3, 2} : std::vector<std::uint16_t>{0, 1, 2, 3});
    const auto model = sample.read();
    ASSERT_TRUE(model.ok()) << model.error().line();
    ASSERT_EQ(model->mesh->triangle_count(), 2U);
    for (const auto& t : model->mesh->triangles()) {
      const auto p = model->mesh->positions();
      const auto a = p[t[1]] - p[t[0]];
      const auto b = p[t[2]] - p[t[0]];
      EXPECT_GT(a.x * b.y - a.y * b.x, 0) << mode;
    }
  }
}

TEST(GltfMeshes, WithoutIndicesVerticesAreTheCorners) {
  tests::GltfSample sample;
  sample.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
  sample.add("meshes", {{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}});
  sample.add("nodes", {{"mesh", 0}});
  const auto model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_EQ(model->mesh->triangle_count(), 1U);
  EXPECT_EQ(model->mesh->parts()[0].name, "");
}

TEST(GltfMeshes, PrimitivesThatShareTheirVerticesAreOnePart) {
  tests::GltfSample sample = tests::square_sample();
  auto& primitives = sample.json["meshes"][0]["primitives"];
  primitives[0]["indices"] = sample.add_corners({0, 1, 2});
  primitives.push_back(
      {{"attributes", {{"POSITION", 0}}}, {"indices", sample.add_corners({0, 2, 3})}, {"material", 0}});
  sample.add("materials", {{"name", "red"}});
  const auto other = sample.add_vec3({0, 0, 5, 1, 0, 5, 0, 1, 5});
  primitives.push_back({{"attributes", {{"POSITION", other}}}});
  const auto model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  const auto parts = model->mesh->parts();
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].vertex_count, 4U);
  EXPECT_EQ(parts[0].triangle_count, 2U);
  EXPECT_EQ(parts[1].name, "square.2");
  EXPECT_TRUE(model->notes.empty()) << "materials are kept";
}

TEST(GltfMeshes, AMeshUsedTwiceIsTwoPartsNamedAfterTheirNodes) {
  tests::GltfSample sample = tests::square_sample();
  sample.add("nodes", {{"name", "other"}, {"mesh", 0}, {"translation", {5, 0, 0}}});
  sample.json["scenes"][0]["nodes"] = {0, 1};
  const auto model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  ASSERT_EQ(model->mesh->parts().size(), 2U);
  EXPECT_EQ(model->mesh->parts()[1].name, "other");
  EXPECT_EQ(document::posed_positions(*model)[4], geometry::ModelPoint(5, 0, 0));
}

TEST(GltfMeshes, PointsLinesAndOtherAttributesAreNoted) {
  tests::GltfSample sample = tests::square_sample();
  auto& primitives = sample.json["meshes"][0]["primitives"];
  primitives[0]["attributes"]["TEXCOORD_0"] = 0;
  primitives[0]["attributes"]["COLOR_0"] = 0;
  primitives.push_back({{"attributes", {{"POSITION", 0}}}, {"mode", 0}});
  const auto model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_EQ(model->notes.size(), 1U) << "of points alone";
  primitives.erase(0);
  EXPECT_EQ(sample.error().place, "/meshes");
}

TEST(GltfMeshes, FaultsAreNamed) {
  tests::GltfSample sample = tests::square_sample();
  auto& primitive = sample.json["meshes"][0]["primitives"][0];
  primitive["indices"] = sample.add_corners({0, 1, 4});
  EXPECT_EQ(sample.error().place, "/accessors/2");
  primitive["indices"] = 1;
  primitive["attributes"]["POSITION"] =
      sample.add_vec3({0, 0, 0, 1, 0, 0, 0, 1, std::numeric_limits<float>::quiet_NaN(), 0, 0, 0});
  EXPECT_EQ(sample.error().place, "/accessors/3");
  primitive["attributes"] = {{"NORMAL", 0}};
  EXPECT_EQ(sample.error().place, "/meshes") << "no triangles without places";
  primitive["attributes"] = {{"POSITION", 0}, {"NORMAL", sample.add_vec3({0, 0, 1})}};
  EXPECT_EQ(sample.error().place, "/accessors/4/count");
}

TEST(GltfMeshes, CornersThatFormNoTriangleAreLeftOutWithANote) {
  tests::GltfSample sample = tests::square_sample();
  sample.json["meshes"][0]["primitives"][0]["indices"] = sample.add_corners({0, 1, 2, 0, 2});
  const auto model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_EQ(model->mesh->triangle_count(), 1U);
  ASSERT_EQ(model->notes.size(), 1U);
  EXPECT_NE(model->notes[0].find("the last 2 of 5 corners"), std::string::npos) << model->notes[0];
}

TEST(GltfMeshes, PrimitivesOfNothingAreNoParts) {
  tests::GltfSample sample = tests::square_sample();
  auto& primitives = sample.json["meshes"][0]["primitives"];
  const auto nothing = [&](const char* type) {
    return sample.add("accessors", {{"componentType", 5126}, {"count", 0}, {"type", type}});
  };
  const auto no_corners = nothing("SCALAR");
  sample.json["accessors"][no_corners]["componentType"] = 5123;
  sample.json["accessors"][no_corners]["bufferView"] = 1;
  primitives.push_back({{"attributes", {{"POSITION", nothing("VEC3")}}}});
  primitives.push_back({{"attributes", {{"NORMAL", 0}}}});
  primitives.push_back({{"attributes", {{"POSITION", 0}, {"NORMAL", 0}}}, {"indices", no_corners}});
  const auto model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_EQ(model->mesh->parts().size(), 1U);
  EXPECT_EQ(model->mesh->triangle_count(), 2U);
  EXPECT_EQ(model->mesh->positions().size(), 4U);
}

TEST(GltfMeshes, ASmallFileMayUseItsMeshManyTimes) {
  tests::GltfSample sample;
  std::vector<float> places;
  std::vector<std::uint16_t> corners;
  for (std::uint16_t i = 0; i < 1000; ++i) {
    for (const float at : {static_cast<float>(i % 30), static_cast<float>(i / 30), 0.0F}) places.push_back(at);
    for (const int next : {0, 1, 30, 30, 1, 31}) {
      corners.push_back(static_cast<std::uint16_t>((i + next) % 1000));
    }
  }
  const auto place = sample.add_vec3(places);
  sample.add("meshes",
             {{"primitives", {{{"attributes", {{"POSITION", place}}}, {"indices", sample.add_corners(corners)}}}}});
  for (int i = 0; i < 60; ++i) sample.add("nodes", {{"mesh", 0}, {"translation", {40 * i, 0, 0}}});
  const auto model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_EQ(model->mesh->parts().size(), 60U);
}

TEST(GltfMeshes, AMotionAloneIsCalledOne) {
  tests::GltfSample sample = tests::square_sample();
  sample.json.erase("meshes");
  sample.json["nodes"] = {{{"name", "hips"}}};
  sample.add("animations", {{"samplers", {{{"input", 0}, {"output", 0}}}},
                            {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "rotation"}}}}}}});
  EXPECT_NE(sample.error().what.find("motions and no mesh"), std::string::npos) << sample.error().line();
}

TEST(GltfMeshes, TrianglesOnOthersAreSheetsOfTheirOwn) {
  tests::GltfSample sample = tests::square_sample();
  sample.json["meshes"][0]["primitives"][0]["indices"] = sample.add_corners({0, 1, 2, 0, 2, 3, 2, 0, 1, 0, 2, 1});
  const auto model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_EQ(model->mesh->triangle_count(), 4U);
  EXPECT_EQ(model->notes.size(), 1U);
}

TEST(GltfMeshes, MaterialsOfParts) {
  tests::GltfSample sample = tests::square_sample();
  sample.json["meshes"][0]["primitives"][0]["material"] = 0;
  sample.add("materials",
             {{"name", "skin"},
              {"pbrMetallicRoughness",
               {{"baseColorFactor", {0.5, 0.25, 2, 1}}, {"metallicFactor", 0.125}, {"roughnessFactor", 0.75}}}});
  const auto model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_EQ(model->materials[0].name, "skin");
  EXPECT_EQ(model->materials[0].base_color, (std::array<double, 4>{0.5, 0.25, 1, 1}));
  EXPECT_EQ(model->materials[0].metallic, 0.125);
}

TEST(GltfMeshes, MissingNormalsOfOnePartAreMade) {
  tests::GltfSample sample = tests::square_sample();
  const auto other = sample.add_vec3({0, 0, 5, 1, 0, 5, 0, 1, 5});
  const auto normals = sample.add_vec3({1, 0, 0, 1, 0, 0, std::numeric_limits<float>::infinity(), 0, 0});
  sample.json["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", other}, {"NORMAL", normals}}}});
  const auto model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_EQ(model->mesh->file_normals()[0], glm::vec3(0, 0, 1));
  EXPECT_EQ(model->mesh->file_normals()[4], glm::vec3(1, 0, 0));
  EXPECT_EQ(model->mesh->file_normals()[6], glm::vec3(0, 0, 1));
}

}  // namespace
}  // namespace penpose::io
