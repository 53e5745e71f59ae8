#pragma once

#include <cstdint>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "core/io/gltf/read/read_gltf.h"
#include "tests/support/models/gltf_sample.h"
#include "tests/support/models/sketched_models.h"

namespace penpose::tests {

/// A .glb file taken apart by other code than that which is tested.
struct FileParts {
  nlohmann::json json;
  std::vector<std::uint8_t> binary;
};
inline FileParts parts_of(const std::vector<std::uint8_t>& bytes) {
  const auto word = [&](std::size_t at) {
    return bytes[at] | (bytes[at + 1] << 8) | (bytes[at + 2] << 16) | (static_cast<std::size_t>(bytes[at + 3]) << 24);
  };
  const auto at = [&](std::size_t i) { return bytes.begin() + static_cast<std::ptrdiff_t>(i); };
  const std::size_t length = word(12);
  FileParts parts{nlohmann::json::parse(at(20), at(20 + length)), {}};
  if (bytes.size() > 20 + length) parts.binary.assign(at(28 + length), bytes.end());
  return parts;
}

/// That `now` has all of `was`: members and entries are equal, lists and the buffer may go on. `but`: pointers whose
/// values may differ.
inline void expect_kept(const nlohmann::json& was, const nlohmann::json& now,
                        const std::vector<std::string>& but = {}) {
  const nlohmann::json flat = was.flatten();
  for (const auto& [pointer, value] : flat.items()) {
    bool differs = pointer == "/buffers/0/byteLength";
    for (const std::string& one : but) differs = differs || pointer.starts_with(one);
    if (differs) continue;
    const nlohmann::json::json_pointer at(pointer);
    ASSERT_TRUE(now.contains(at)) << pointer << " is gone";
    const nlohmann::json& whole = was[at];
    if (whole.empty() && !whole.is_null()) {
      EXPECT_EQ(now[at].type(), whole.type()) << pointer;
    } else {
      EXPECT_EQ(now[at], value) << pointer;
    }
  }
}
inline void expect_kept(const std::vector<std::uint8_t>& was, const std::vector<std::uint8_t>& now,
                        const std::vector<std::string>& but = {}) {
  const FileParts before = parts_of(was);
  const FileParts after = parts_of(now);
  expect_kept(before.json, after.json, but);
  const std::size_t length = before.json["buffers"][0]["byteLength"];
  ASSERT_GE(after.binary.size(), length);
  EXPECT_TRUE(std::equal(before.binary.begin(), before.binary.begin() + static_cast<std::ptrdiff_t>(length),
                         after.binary.begin()));
}

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
      {"POSITION", sample.add_vec3(positions)},
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
                           {"targets", {{{"POSITION", sample.add_vec3(lift)}}}},
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

inline document::Model read_glb(const std::vector<std::uint8_t>& bytes) {
  auto model = io::read_gltf(bytes);
  EXPECT_TRUE(model.ok()) << model.error().line();
  return std::move(model).value();
}

/// With a sketched control, "curl".
inline document::Model with_curl(document::Model model) {
  const auto deformer =
      articulation::build_deformer(make_trunk().curl(), *document::make_canvas(model).value()).value();
  return document::with_deformers(std::move(model), articulation::SketchedDeformers::make({deformer}).value()).value();
}

}  // namespace penpose::tests
