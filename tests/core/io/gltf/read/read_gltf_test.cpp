#include "core/io/gltf/read/read_gltf.h"

#include <gtest/gtest.h>

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
