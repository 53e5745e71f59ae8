#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/models/bounded_points.h"
#include "tests/support/models/gltf_sample.h"
#include "tests/support/models/sketched_models.h"

namespace penpose::tests {

/// A trunk of an avatar: textured, with tangents, two sets of texture coordinates, colours, a target, two clips, and
/// things that nobody knows.
inline GltfSample textured_trunk() {
  GltfSample sample;
  const Trunk trunk = make_trunk();
  const auto points = trunk.canvas->positions();
  const std::size_t count = points.size();
  std::vector<float> positions;
  for (const auto& p : points) {
    for (int axis = 0; axis < 3; ++axis) positions.push_back(static_cast<float>(p[axis]));
  }
  std::vector<std::uint16_t> corners;
  for (const auto& t : trunk.canvas->mesh().triangles()) {
    for (const std::uint32_t v : t) corners.push_back(static_cast<std::uint16_t>(v));
  }
  std::vector<float> normals;
  std::vector<float> tangents;
  std::vector<float> lift(3 * count, 0.0F);
  for (std::size_t v = 0; v < count; ++v) {
    normals.insert(normals.end(), {0, 0, 1});
    tangents.insert(tangents.end(), {1, 0, 0, -1});
  }
  lift[2] = 0.5F;
  const std::vector<float> uv(2 * count, 0.25F);
  const nlohmann::json attributes = {
      {"POSITION", add_points(sample, positions)},
      {"NORMAL", sample.add_vec3(normals)},
      {"TANGENT", sample.add_accessor(tangents, "VEC4", 4, 5126)},
      {"TEXCOORD_0", sample.add_accessor(uv, "VEC2", 2, 5126)},
      {"TEXCOORD_1", sample.add_accessor(uv, "VEC2", 2, 5126)},
      {"COLOR_0", sample.add_accessor(std::vector<float>(3 * count, 0.5F), "VEC3", 3, 5126)},
      {"_CUSTOM", sample.add_accessor(std::vector<float>(count, 7.0F), "SCALAR", 1, 5126)}};
  sample.add("meshes", {{"name", "trunk"},
                        {"primitives",
                         {{{"attributes", attributes},
                           {"indices", sample.add_corners(corners)},
                           {"material", 0},
                           {"targets", {{{"POSITION", add_points(sample, lift)}}}},
                           {"extensions", {{"ACME_hair", {{"strands", 12}}}}}}}},
                        {"weights", {0.125}},
                        {"extras", {{"targetNames", {"lift"}}, {"acme", "mine"}}}});
  sample.add("materials", {{"name", "skin"},
                           {"doubleSided", true},
                           {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}, {"texCoord", 1}}}}},
                           {"extensions", {{"KHR_materials_unlit", nlohmann::json::object()}}},
                           {"extras", {1, "two", nullptr}}});
  sample.add("textures", {{"source", 0}, {"sampler", 0}});
  sample.add("samplers", {{"wrapS", 33071}});
  sample.add("images", {{"mimeType", "image/png"},
                        {"bufferView", sample.add_view(std::vector<std::uint8_t>{0x89, 'P', 'N', 'G', 1, 2, 3})}});
  sample.add("nodes", {{"name", "body"}, {"children", {1, 2}}, {"extras", {{"deep", {{"er", {1.5, -0.0}}}}}}});
  sample.add("nodes", {{"name", "trunk"}, {"mesh", 0}});
  sample.add("nodes", {{"name", "eye"}, {"camera", 0}, {"translation", {0, 0, 3}}});
  sample.add("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.1}}}});
  sample.add("scenes", {{"nodes", {0}}, {"name", "stage"}});
  sample.json["scene"] = 0;
  const auto clip = [&](const char* name, const std::vector<float>& weights) {
    const auto times = sample.add_accessor(std::vector<float>{0, 1}, "SCALAR", 1, 5126);
    sample.json["accessors"][times]["min"] = {0};
    sample.json["accessors"][times]["max"] = {1};
    const auto look = sample.add_vec3({0, 0, 3, 0, 1, 3});
    sample.add("animations", {{"name", name},
                              {"samplers",
                               {{{"input", times}, {"output", sample.add_accessor(weights, "SCALAR", 1, 5126)}},
                                {{"input", times}, {"output", look}}}},
                              {"channels",
                               {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "weights"}}}},
                                {{"sampler", 1}, {"target", {{"node", 2}, {"path", "translation"}}}}}}});
  };
  clip("up", {0, 1});
  clip("over", {-0.5F, 1.5F});
  sample.json["extensionsUsed"] = {"KHR_materials_unlit", "ACME_hair", "VRMC_vrm"};
  sample.json["extensions"] = {{"ACME_hair", {{"length", 0.1}}}};
  sample.json["extras"] = {{"author", "somebody"}};
  sample.json["asset"]["generator"] = "ACME exporter";
  return sample;
}

/// The same, and a second node far away that shows the same mesh; the first clip moves both by one sampler.
inline GltfSample twin_trunks() {
  GltfSample sample = textured_trunk();
  sample.add("nodes", {{"name", "twin"}, {"mesh", 0}, {"translation", {50, 0, 0}}});
  sample.json["nodes"][0]["children"] = {1, 2, 3};
  auto& up = sample.json["animations"][0];
  up["channels"].push_back({{"sampler", 0}, {"target", {{"node", 3}, {"path", "weights"}}}});
  return sample;
}

/// The same trunk with positions of 16 bits, 4096 steps a metre.
inline GltfSample quantised_trunk() {
  GltfSample sample = textured_trunk();
  const Trunk trunk = make_trunk();
  std::vector<std::int16_t> places;
  for (const auto& p : trunk.canvas->positions()) {
    for (int axis = 0; axis < 3; ++axis) places.push_back(static_cast<std::int16_t>(std::lround(p[axis] * 4096)));
    places.push_back(0);
  }
  const std::size_t view = sample.add_view(places);
  sample.json["bufferViews"][view]["byteStride"] = 8;
  auto& primitive = sample.json["meshes"][0]["primitives"][0];
  auto& positions = sample.json["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
  positions["bufferView"] = view;
  positions["componentType"] = 5122;
  positions.erase("min");
  positions.erase("max");
  sample.json["nodes"][1]["scale"] = {1.0 / 4096, 1.0 / 4096, 1.0 / 4096};
  sample.json["extensionsUsed"].push_back("KHR_mesh_quantization");
  sample.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  return sample;
}

/// With a sketched control, "curl".
inline document::Model with_curl(document::Model model) {
  const auto deformer =
      articulation::build_deformer(make_trunk().curl(), *document::make_canvas(model).value()).value();
  return document::with_deformers(std::move(model), articulation::SketchedDeformers::make({deformer}).value()).value();
}

}  // namespace penpose::tests
