#include "core/model_io/gltf_structure.h"

#include <gtest/gtest.h>

namespace penpose::model_io {
namespace {

std::string place(const char* text) {
  const auto model = gltf_structure(Json::parse(text));
  return model ? "(no error)" : model.error().place;
}

TEST(GltfStructure, WhatIsNotSaidIsAsTheSpecificationSays) {
  const auto model = gltf_structure(Json::parse(R"({"asset": {"version": "2.0"},
    "bufferViews": [{"buffer": 0, "byteLength": 12}],
    "accessors": [{"componentType": 5126, "count": 1, "type": "VEC3"}],
    "materials": [{}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "nodes": [{}], "scenes": [{}],
    "skins": [{"joints": [0]}],
    "animations": [{"channels": [{"sampler": 0, "target": {"node": 0, "path": "weights"}}],
                    "samplers": [{"input": 0, "output": 0}]}]})"));
  ASSERT_TRUE(model) << model.error().line();
  EXPECT_EQ(model->bufferViews[0].byteOffset, 0U);
  EXPECT_EQ(model->bufferViews[0].byteStride, 0U);
  EXPECT_EQ(model->accessors[0].bufferView, -1);
  EXPECT_FALSE(model->accessors[0].normalized);
  EXPECT_FALSE(model->accessors[0].sparse.isSparse);
  EXPECT_EQ(model->materials[0].pbrMetallicRoughness.baseColorFactor, (std::vector<double>{1, 1, 1, 1}));
  EXPECT_EQ(model->materials[0].pbrMetallicRoughness.metallicFactor, 1.0);
  EXPECT_EQ(model->meshes[0].primitives[0].mode, TINYGLTF_MODE_TRIANGLES);
  EXPECT_EQ(model->meshes[0].primitives[0].indices, -1);
  EXPECT_EQ(model->meshes[0].primitives[0].material, -1);
  EXPECT_EQ(model->nodes[0].mesh, -1);
  EXPECT_EQ(model->nodes[0].skin, -1);
  EXPECT_EQ(model->skins[0].inverseBindMatrices, -1);
  EXPECT_EQ(model->animations[0].samplers[0].interpolation, "LINEAR");
  EXPECT_EQ(model->defaultScene, -1);
}

TEST(GltfStructure, WhatIsSaidIsTaken) {
  const auto model = gltf_structure(Json::parse(R"({"asset": {"version": "2.0"}, "scene": 1,
    "bufferViews": [{"buffer": 0, "byteOffset": 4294967296, "byteLength": 12, "byteStride": 8}],
    "accessors": [{"bufferView": 0, "byteOffset": 4, "normalized": true, "componentType": 5123, "count": 7,
                   "type": "MAT4", "sparse": {"count": 2,
                   "indices": {"bufferView": 0, "byteOffset": 8, "componentType": 5121},
                   "values": {"bufferView": 0, "byteOffset": 16}}}],
    "materials": [{"name": "skin", "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 1, 1],
                                                           "metallicFactor": 0.1, "roughnessFactor": 0.75}}],
    "meshes": [{"name": "face", "weights": [0.5, 1], "primitives": [{"attributes": {"POSITION": 0, "NORMAL": 0},
                "indices": 0, "material": 0, "mode": 5, "targets": [{"POSITION": 0}, {}]}]}],
    "nodes": [{"name": "a", "children": [1], "mesh": 0, "skin": 0, "weights": [1, 0],
               "translation": [1, 2, 3], "rotation": [0, 0, 0, 1], "scale": [2, 2, 2]},
              {"matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1], "translation": [9, 9, 9]}],
    "skins": [{"name": "s", "joints": [1, 0], "inverseBindMatrices": 0}],
    "scenes": [{"nodes": [0]}, {"nodes": [1]}],
    "animations": [{"name": "walk", "channels": [{"sampler": 1, "target": {"node": 1, "path": "scale"}}],
                    "samplers": [{"input": 0, "output": 0},
                                 {"input": 0, "interpolation": "STEP", "output": 0}]}]})"));
  ASSERT_TRUE(model) << model.error().line();
  EXPECT_EQ(model->bufferViews[0].byteOffset, 4294967296U);
  EXPECT_EQ(model->bufferViews[0].byteStride, 8U);
  const tinygltf::Accessor& accessor = model->accessors[0];
  EXPECT_EQ(accessor.byteOffset, 4U);
  EXPECT_TRUE(accessor.normalized);
  EXPECT_EQ(accessor.componentType, 5123);
  EXPECT_EQ(accessor.count, 7U);
  EXPECT_EQ(accessor.type, TINYGLTF_TYPE_MAT4);
  EXPECT_TRUE(accessor.sparse.isSparse);
  EXPECT_EQ(accessor.sparse.count, 2);
  EXPECT_EQ(accessor.sparse.indices.byteOffset, 8);
  EXPECT_EQ(accessor.sparse.indices.componentType, 5121);
  EXPECT_EQ(accessor.sparse.values.byteOffset, 16);
  EXPECT_EQ(model->materials[0].name, "skin");
  EXPECT_EQ(model->materials[0].pbrMetallicRoughness.roughnessFactor, 0.75);
  const tinygltf::Primitive& primitive = model->meshes[0].primitives[0];
  EXPECT_EQ(primitive.attributes.size(), 2U);
  EXPECT_EQ(primitive.mode, 5);
  ASSERT_EQ(primitive.targets.size(), 2U);
  EXPECT_EQ(primitive.targets[0].at("POSITION"), 0);
  EXPECT_EQ(model->meshes[0].weights, (std::vector<double>{0.5, 1}));
  EXPECT_EQ(model->nodes[0].children, std::vector<int>{1});
  EXPECT_EQ(model->nodes[0].translation, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(model->nodes[1].matrix[13], 6.0);
  EXPECT_TRUE(model->nodes[1].translation.empty()) << "a matrix stands for the three";
  EXPECT_EQ(model->skins[0].joints, (std::vector<int>{1, 0}));
  EXPECT_EQ(model->scenes[1].nodes, std::vector<int>{1});
  EXPECT_EQ(model->defaultScene, 1);
  EXPECT_EQ(model->animations[0].channels[0].target_node, 1);
  EXPECT_EQ(model->animations[0].channels[0].target_path, "scale");
  EXPECT_EQ(model->animations[0].samplers[1].interpolation, "STEP");
}

TEST(GltfStructure, FaultsAreNamedByTheirPlace) {
  EXPECT_EQ(place(R"({"bufferViews": [{"buffer": 0, "byteLength": 12, "byteStride": 6}]})"),
            "/bufferViews/0/byteStride");
  EXPECT_EQ(place(R"({"accessors": [{"componentType": 5126, "count": 1, "type": "VEC5"}]})"), "/accessors/0/type");
  EXPECT_EQ(place(R"({"animations": [{"samplers": [], "channels": [{"sampler": 0, "target": {"path": "scale"}}]}]})"),
            "/animations/0/channels/0/target");
}

}  // namespace
}  // namespace penpose::model_io
