#include "core/io/gltf/read/read_gltf.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "core/io/model/write_model.h"
#include "tests/support/models/gltf_sample.h"

namespace penpose::io {
namespace {

TEST(ReadGltf, ReadsTheSamples) {
  for (auto& sample : {tests::square_sample(), tests::morph_sample(), tests::skin_sample()}) {
    auto copy = sample;
    const auto model = copy.read();
    ASSERT_TRUE(model.ok()) << model.error().line();
    EXPECT_EQ(model->mesh->triangle_count(), 2U);
    EXPECT_EQ(model->pose.size(), model->rig->parameters().size());
  }
}

TEST(ReadGltf, EveryByteChangedGivesAModelOrAnError) {
  for (auto sample : {tests::morph_sample(), tests::skin_sample()}) {
    const auto bytes = sample.glb();
    std::size_t refused = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      for (const std::uint8_t value : {std::uint8_t{0}, std::uint8_t{0xff}, std::uint8_t{'9'}, std::uint8_t{'['}}) {
        auto bent = bytes;
        bent[i] = value;
        const auto model = read_gltf(bent);
        if (model) continue;
        ++refused;
        EXPECT_FALSE(model.error().what.empty());
        EXPECT_FALSE(model.error().place.empty()) << model.error().line();
        EXPECT_FALSE(model.error().remedy.empty()) << model.error().line();
      }
    }
    EXPECT_GT(refused, bytes.size());
  }
}

TEST(ReadGltf, TransformsThatMultiplyBeyondMeasureAreRefused) {
  tests::GltfSample sample = tests::square_sample();
  for (std::size_t i = 0; i < 30; ++i) {
    sample.json["nodes"].push_back({{"scale", {1e15, 1e15, 1e15}}, {"children", {i == 0 ? 0 : i}}});
  }
  sample.json["scenes"][0]["nodes"] = {30};
  EXPECT_EQ(sample.error().place, "/nodes");
}

TEST(ReadGltf, APoseBeyondMeasureIsLeftOutAndTheFileOpens) {
  auto sample = tests::skin_sample();
  auto model = sample.read();
  ASSERT_TRUE(model.ok());
  rig::BlendShape far;
  far.parameter.name = "far";
  far.vertices = {0};
  far.deltas = {{1e32F, 0, 0}};
  auto shapes = rig::BlendShapes::make({far}, model->mesh->vertex_count());
  ASSERT_TRUE(shapes.ok());
  auto more = document::with_controls(std::move(model).value(), std::move(shapes).value(), nullptr);
  ASSERT_TRUE(more.ok());
  const auto at = rig::find_parameter(more->rig->parameters(), "far");
  ASSERT_TRUE(at);
  more->pose[*at] = 1;
  const auto bytes = write_glb(*more);
  ASSERT_TRUE(bytes.ok()) << bytes.error().line();
  const auto again = read_gltf(*bytes);
  ASSERT_TRUE(again.ok()) << again.error().line();
  EXPECT_EQ(again->pose, rig::rest_pose(*again->rig));
  EXPECT_TRUE(std::any_of(again->notes.begin(), again->notes.end(), [](const std::string& note) {
    return note.find("vertex 0 too far away and was left out") != std::string::npos;
  }));
}

TEST(ReadGltf, TrianglesWithoutAreaAreNoted) {
  tests::GltfSample sample = tests::square_sample();
  sample.json["meshes"][0]["primitives"][0]["indices"] = sample.add_corners({0, 1, 2, 1, 1, 3});
  const auto model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_EQ(model->mesh->triangle_count(), 1U);
  EXPECT_EQ(model->notes, std::vector<std::string>{"1 triangles without area were left out"});
}

}  // namespace
}  // namespace penpose::io
