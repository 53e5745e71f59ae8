#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include "core/base/json/json.h"
#include "core/io/gltf/read/read_gltf.h"
#include "core/io/model/write_model.h"
#include "tests/support/models/gltf_sample.h"
#include "tests/support/models/model_samples.h"

namespace penpose::io {
namespace {

/// Of models that were read, too, what the writer makes itself.
const WriteOptions k_bare{.bare = true};

document::Model round_trip(const document::Model& model) {
  const auto bytes = write_glb(model, k_bare).value();
  auto again = read_gltf(bytes);
  EXPECT_TRUE(again.ok()) << again.error().line();
  return std::move(again).value();
}

json::Json json_of(const document::Model& model) {
  const auto bytes = write_glb(model, k_bare).value();
  const std::size_t size = bytes[12] | (bytes[13] << 8) | (bytes[14] << 16);
  return json::Json::parse(bytes.begin() + 20, bytes.begin() + 20 + static_cast<std::ptrdiff_t>(size));
}

TEST(WriteGlb, WhatIsWrittenLoadsBackEqual) {
  const document::Model model = tests::full_model();
  const document::Model again = round_trip(model);
  EXPECT_EQ(document::state_hash(again), document::state_hash(model));
  EXPECT_EQ(again.pose, model.pose);
  EXPECT_TRUE(again.notes.empty());
  ASSERT_EQ(again.skeleton->joints().size(), 4U);
  EXPECT_EQ(again.skeleton->joints()[1].minimum, glm::dvec3(-0.5));
  EXPECT_EQ(again.materials[1].name, "glass");
  EXPECT_EQ(again.materials[1].base_color, model.materials[1].base_color);
  EXPECT_EQ(again.shapes->shapes()[3].normal_deltas[0], glm::vec3(0, 0.5F, 0));
  EXPECT_EQ(document::posed_positions(again), document::posed_positions(model));
  EXPECT_EQ(write_glb(again, k_bare).value(), write_glb(round_trip(again), k_bare).value());
}

TEST(WriteGlb, ReadModelsLoadBackEqual) {
  for (auto sample : {tests::square_sample(), tests::morph_sample(), tests::skin_sample()}) {
    const auto model = sample.read().value();
    EXPECT_EQ(document::state_hash(round_trip(model)), document::state_hash(model));
  }
  const auto empty = tests::model_with_empty_part();
  EXPECT_EQ(document::state_hash(round_trip(empty)), document::state_hash(empty));
}

TEST(WriteGlb, ThePoseStandsWhereOtherProgramsLookForIt) {
  auto model = tests::morph_sample().read().value();
  model.pose = {0.75};
  EXPECT_EQ(json_of(model)["meshes"][0]["weights"], json::Json({0.75}));
  EXPECT_EQ(json_of(model)["meshes"][0]["extras"]["targetNames"], json::Json({"lift"}));
  EXPECT_EQ(json_of(model)["asset"]["generator"], "penpose");
  auto skinned = tests::skin_sample().read().value();
  skinned.pose[5] = 1;  // tip.rz
  const json::Json node = json_of(skinned)["nodes"][1];
  EXPECT_NEAR(node["rotation"][2].get<double>(), 0.479425538604203, 1e-12);
  EXPECT_NEAR(node["rotation"][3].get<double>(), 0.877582561890373, 1e-12);
}

TEST(WriteGlb, AnotherParserAgrees) {
  const auto bytes = write_glb(tests::full_model()).value();
  tinygltf::TinyGLTF loader;
  tinygltf::Model parsed;
  std::string errors;
  std::string warnings;
  ASSERT_TRUE(
      loader.LoadBinaryFromMemory(&parsed, &errors, &warnings, bytes.data(), static_cast<unsigned>(bytes.size())))
      << errors;
  EXPECT_EQ(errors + warnings, "");
  EXPECT_EQ(parsed.meshes.size(), 5U);
  const int position = parsed.meshes[0].primitives[0].attributes.at("POSITION");
  EXPECT_EQ(parsed.accessors[static_cast<std::size_t>(position)].minValues.size(), 3U);
  EXPECT_EQ(parsed.skins.size(), 1U);
}

TEST(WriteGlb, NormalsAreMadeWhereThereAreNone) {
  const auto again = round_trip(tests::square_sample().read().value());
  ASSERT_EQ(again.mesh->file_normals().size(), 4U);
  for (const glm::vec3& n : again.mesh->file_normals()) EXPECT_EQ(n, glm::vec3(0, 0, 1));
}

}  // namespace
}  // namespace penpose::io
