#include "core/io/gltf/read/internal/gltf_schema.h"

#include <gtest/gtest.h>

#include "tests/support/models/gltf_sample.h"

namespace penpose::io {
namespace {

/// The place of the error when one member of a good document is something else.
std::string place(const char* pointer, const nlohmann::json& value) {
  tests::GltfSample sample = tests::skin_sample();
  sample.set_buffer();
  sample.json["nodes"][1]["rotation"] = {0, 0, 0, 1};
  sample.json["materials"] = {{{"pbrMetallicRoughness", {{"metallicFactor", 0.5}}}}};
  sample.json["animations"] = {{{"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "scale"}}}}}},
                                {"samplers", {{{"input", 0}, {"output", 0}}}}}};
  sample.json[nlohmann::json::json_pointer(pointer)] = value;
  std::vector<std::string> notes;
  const auto vetted = vet_gltf(json::parse_json(base::as_bytes(sample.json.dump())).value(), notes);
  return vetted ? "(no error)" : vetted.error().place;
}

TEST(GltfSchema, AcceptsAGoodDocument) {
  EXPECT_EQ(place("/extras", "whatever"), "(no error)");
  EXPECT_EQ(place("/accessors/0/count", 4.0), "(no error)");
}

TEST(GltfSchema, EveryWrongTypeIsNamed) {
  const nlohmann::json wrong_for_all = nlohmann::json::array({nlohmann::json::array()});
  for (const char* pointer : {"/asset",
                              "/asset/version",
                              "/accessors/0",
                              "/accessors/0/bufferView",
                              "/accessors/0/byteOffset",
                              "/accessors/0/componentType",
                              "/accessors/0/count",
                              "/accessors/0/type",
                              "/accessors/0/normalized",
                              "/accessors/0/sparse",
                              "/bufferViews/0/buffer",
                              "/bufferViews/0/byteLength",
                              "/bufferViews/0/byteOffset",
                              "/bufferViews/0/byteStride",
                              "/meshes/0/primitives/0",
                              "/meshes/0/primitives/0/attributes",
                              "/meshes/0/primitives/0/attributes/POSITION",
                              "/meshes/0/primitives/0/indices",
                              "/meshes/0/primitives/0/mode",
                              "/meshes/0/primitives/0/material",
                              "/nodes/0",
                              "/nodes/0/mesh",
                              "/nodes/0/skin",
                              "/nodes/1/rotation",
                              "/nodes/1/matrix",
                              "/skins/0",
                              "/skins/0/inverseBindMatrices",
                              "/scene",
                              "/animations/0/channels/0/sampler",
                              "/animations/0/channels/0/target",
                              "/animations/0/channels/0/target/node",
                              "/animations/0/channels/0/target/path",
                              "/animations/0/samplers/0/input",
                              "/materials/0/pbrMetallicRoughness",
                              "/materials/0/pbrMetallicRoughness/metallicFactor"}) {
    EXPECT_EQ(place(pointer, wrong_for_all), pointer);
  }
  for (const char* pointer : {"/asset", "/accessors/0", "/accessors/0/componentType", "/bufferViews/0/buffer",
                              "/meshes/0/primitives/0", "/meshes/0/primitives/0/attributes", "/nodes/0", "/skins/0",
                              "/animations/0/channels/0/target", "/animations/0/samplers/0/input"}) {
    EXPECT_NE(place(pointer, nullptr), "(no error)") << pointer;
  }
  for (const char* pointer : {"/accessors", "/nodes", "/meshes/0/primitives", "/nodes/1/children", "/skins/0/joints",
                              "/scenes/0/nodes", "/meshes/0/weights"}) {
    EXPECT_NE(place(pointer, 7), "(no error)");
  }
}

TEST(GltfSchema, WhatIsNotNeededMayBeNullAndNamesMayBeAnything) {
  for (const char* pointer :
       {"/materials", "/meshes/0/name", "/meshes/0/primitives/0/material", "/meshes/0/primitives/0/mode",
        "/nodes/0/skin", "/nodes/1/rotation", "/nodes/1/children", "/accessors/0/normalized", "/asset/version",
        "/scene", "/materials/0/pbrMetallicRoughness", "/animations/0/samplers/0/interpolation"}) {
    EXPECT_EQ(place(pointer, nullptr), "(no error)") << pointer;
  }
  for (const char* pointer :
       {"/meshes/0/name", "/nodes/0/name", "/skins/0/name", "/animations/0/samplers/0/interpolation"}) {
    EXPECT_EQ(place(pointer, 0), "(no error)") << pointer;
  }
  tests::GltfSample sample = tests::square_sample();
  sample.json["nodes"][0]["name"] = 7;
  sample.json["meshes"][0]["name"] = nullptr;
  EXPECT_TRUE(sample.read().ok());
}

TEST(GltfSchema, OtherVersionsAreNamedBeforeTheirFormIsCalledDamaged) {
  EXPECT_EQ(place("/asset/version", "1.0"), "/asset/version");
  EXPECT_EQ(place("/asset/version", 1.0), "/asset/version");
  EXPECT_EQ(place("/asset/version", 2), "(no error)");
  tests::GltfSample sample = tests::square_sample();
  sample.json = {{"asset", {{"version", "1.0"}}}, {"bufferViews", {{"view", {{"buffer", "binary"}}}}}};
  sample.json["meshes"] = {{"mesh", {{"primitives", nlohmann::json::array()}}}};
  EXPECT_NE(sample.error().what.find("1.0"), std::string::npos) << sample.error().line();
  sample.json["asset"].erase("version");
  EXPECT_EQ(sample.error().place, "/asset/version") << sample.error().line();
}

TEST(GltfSchema, IndicesAndNumbersKeepTheirBounds) {
  EXPECT_EQ(place("/accessors/0/count", 0), "(no error)") << "of nothing";
  EXPECT_EQ(place("/bufferViews/0/byteStride", 0), "(no error)") << "as in glTF 1.0";
  EXPECT_EQ(place("/accessors/0/count", -4), "/accessors/0/count");
  EXPECT_EQ(place("/accessors/0/count", 4294967297LL), "/accessors/0/count");
  EXPECT_EQ(place("/accessors/0/count", 1e30), "/accessors/0/count");
  EXPECT_EQ(place("/bufferViews/0/byteStride", 253), "/bufferViews/0/byteStride");
  EXPECT_EQ(place("/bufferViews/0/byteOffset", 18446744073709551615ULL), "/bufferViews/0/byteOffset");
  EXPECT_EQ(place("/nodes/0/mesh", 1), "/nodes/0/mesh");
  EXPECT_EQ(place("/nodes/0/mesh", -1), "/nodes/0/mesh");
  EXPECT_EQ(place("/skins/0/joints/1", 3), "/skins/0/joints/1");
  EXPECT_EQ(place("/scene", 5), "/scene");
  EXPECT_EQ(place("/meshes/0/primitives/0/mode", 7), "/meshes/0/primitives/0/mode");
  EXPECT_EQ(place("/nodes/1/translation", {1, 2}), "/nodes/1/translation");
  EXPECT_EQ(place("/animations/0/channels/0/sampler", 1), "/animations/0/channels/0/sampler");
}

TEST(GltfSchema, NodesFormTrees) {
  EXPECT_EQ(place("/nodes/2/children", {1}), "/nodes/1");
  EXPECT_EQ(place("/nodes/0/children", {0}), "/nodes/0");
  EXPECT_EQ(place("/nodes/0/children", {2}), "/nodes/1/children/0");
  EXPECT_EQ(place("/nodes/0/children", {1, 1}), "/nodes/0/children/1");
}

TEST(GltfSchema, ALongChainOfNodesIsNoTrouble) {
  tests::GltfSample sample = tests::square_sample();
  sample.set_buffer();
  for (std::size_t i = 0; i < 20000; ++i) sample.json["nodes"].push_back({{"children", {i + 2}}});
  sample.json["nodes"].push_back({{"mesh", 0}});
  std::vector<std::string> notes;
  EXPECT_TRUE(vet_gltf(json::parse_json(base::as_bytes(sample.json.dump())).value(), notes).ok());
  const auto model = sample.read();
  EXPECT_TRUE(model.ok()) << model.error().line();
}

TEST(GltfSchema, RequiredExtensionsAreRefusedByName) {
  EXPECT_EQ(place("/extensionsRequired", {"KHR_mesh_quantization", "KHR_gaussian_splatting"}), "/extensionsRequired/1");
  EXPECT_EQ(place("/extensionsRequired", {3}), "/extensionsRequired/0");
  EXPECT_EQ(place("/extensionsRequired", {"KHR_materials_unlit"}), "(no error)");
  EXPECT_EQ(place("/extensionsUsed", {"KHR_gaussian_splatting"}), "(no error)") << "used, but not required";
  EXPECT_EQ(
      place("/extensionsRequired", {"EXT_meshopt_compression", "KHR_draco_mesh_compression", "KHR_animation_pointer",
                                    "VRMC_vrm", "KHR_texture_transform", "KHR_techniques_webgl", "EXT_mesh_features"}),
      "(no error)");
}

TEST(GltfSchema, AnUnknownExtensionIsNamedBeforeWhatItChangesIsCalledDamaged) {
  tests::GltfSample sample = tests::square_sample();
  sample.set_buffer();
  sample.json["extensionsRequired"] = {"EXT_other_compression"};
  sample.json["accessors"][1].erase("bufferView");
  sample.json["bufferViews"][0].erase("buffer");
  std::vector<std::string> notes;
  const auto vetted = vet_gltf(json::parse_json(base::as_bytes(sample.json.dump())).value(), notes);
  ASSERT_FALSE(vetted.ok());
  EXPECT_EQ(vetted.error().place, "/extensionsRequired/0");
  EXPECT_NE(vetted.error().what.find("EXT_other_compression"), std::string::npos);
}

TEST(GltfSchema, ChannelsWithoutANodeAreLeftAloneWithANote) {
  tests::GltfSample sample = tests::square_sample();
  const auto times = sample.add_accessor(std::vector<float>{0, 1}, "SCALAR", 1, 5126);
  const auto values = sample.add_vec3({0, 0, 0, 1, 0, 0});
  const nlohmann::json pointer = {
      {"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", "/materials/0/emissiveFactor"}}}}}};
  sample.add("animations", {{"samplers", {{{"input", times}, {"output", values}}}},
                            {"channels",
                             {{{"sampler", 0}, {"target", {{"path", "translation"}}}},
                              {{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}},
                              {{"sampler", 0}, {"target", pointer}}}}});
  sample.set_buffer();
  std::vector<std::string> notes;
  const auto vetted = vet_gltf(json::parse_json(base::as_bytes(sample.json.dump())).value(), notes);
  ASSERT_TRUE(vetted.ok()) << vetted.error().line();
  EXPECT_EQ((*vetted)["animations"][0]["channels"].size(), 1U);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].find("2 channels"), std::string::npos) << notes[0];
  EXPECT_TRUE(sample.read().ok());
  // Also where nothing is left of the animation.
  sample.json["animations"][0]["channels"].erase(1);
  EXPECT_TRUE(sample.read().ok());
}

TEST(GltfSchema, OnlyWhatWasCheckedIsHandedOn) {
  tests::GltfSample sample = tests::square_sample();
  sample.set_buffer();
  sample.json["images"] = {{{"uri", "x.png"}}};
  sample.json["extras"] = {{"a", 1}};
  sample.json["nodes"][0]["extensions"] = {{"EXT", 1}};
  std::vector<std::string> notes;
  const auto vetted = vet_gltf(json::parse_json(base::as_bytes(sample.json.dump())).value(), notes);
  ASSERT_TRUE(vetted.ok());
  EXPECT_EQ(vetted->size(), 6U);  // asset, bufferViews, accessors, meshes, nodes, scenes
  EXPECT_FALSE((*vetted)["nodes"][0].contains("extensions"));
  EXPECT_TRUE(notes.empty()) << "pictures are read apart";
}

}  // namespace
}  // namespace penpose::io
