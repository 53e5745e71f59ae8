#pragma once

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/io/gltf/read/read_gltf.h"
#include "tests/support/error_of.h"

namespace penpose::tests {

/// A glTF document that a test makes and then bends.
struct GltfSample {
  nlohmann::json json = {{"asset", {{"version", "2.0"}}}};
  std::vector<std::uint8_t> binary;

  std::size_t add(const char* array, nlohmann::json object) {
    json[array].push_back(std::move(object));
    return json[array].size() - 1;
  }
  template <typename T>
  std::size_t add_view(const std::vector<T>& numbers) {
    const std::size_t start = binary.size();
    binary.resize(start + numbers.size() * sizeof(T));
    std::memcpy(binary.data() + start, numbers.data(), numbers.size() * sizeof(T));
    const std::size_t end = binary.size();
    while (binary.size() % 4 != 0) binary.push_back(0);
    return add("bufferViews", {{"buffer", 0}, {"byteOffset", start}, {"byteLength", end - start}});
  }
  template <typename T>
  std::size_t add_accessor(const std::vector<T>& numbers, const char* type, std::size_t components,
                           int component_type) {
    return add("accessors", {{"bufferView", add_view(numbers)},
                             {"componentType", component_type},
                             {"count", numbers.size() / components},
                             {"type", type}});
  }
  std::size_t add_vec3(const std::vector<float>& numbers) { return add_accessor(numbers, "VEC3", 3, 5126); }
  std::size_t add_corners(const std::vector<std::uint16_t>& corners) {
    return add_accessor(corners, "SCALAR", 1, 5123);
  }

  void set_buffer() { json["buffers"] = {{{"byteLength", binary.size()}}}; }

  /// The document as a .glb file.
  [[nodiscard]] std::vector<std::uint8_t> glb() {
    set_buffer();
    return glb_of(json.dump(), binary);
  }
  [[nodiscard]] static std::vector<std::uint8_t> glb_of(std::string text, const std::vector<std::uint8_t>& data) {
    while (text.size() % 4 != 0) text += ' ';
    std::vector<std::uint8_t> bytes;
    const auto word = [&](std::size_t value) {
      for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    };
    word(0x46546c67);
    word(2);
    word(28 + text.size() + data.size());
    word(text.size());
    word(0x4e4f534a);
    bytes.insert(bytes.end(), text.begin(), text.end());
    word(data.size());
    word(0x004e4942);
    bytes.insert(bytes.end(), data.begin(), data.end());
    return bytes;
  }
  [[nodiscard]] base::Result<document::Model> read() { return io::read_gltf(glb()); }
  [[nodiscard]] base::Error error() {
    auto model = read();
    return error_of(model);
  }
};

/// A square of four vertices and two triangles in the plane z = 0, mesh "square" on node "square".
inline GltfSample square_sample() {
  GltfSample sample;
  sample.add_vec3({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
  sample.add_corners({0, 1, 2, 0, 2, 3});
  sample.add("meshes", {{"name", "square"}, {"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}});
  sample.add("nodes", {{"name", "square"}, {"mesh", 0}});
  sample.add("scenes", {{"nodes", {0}}});
  return sample;
}

/// The square with one sparse morph target "lift" that moves vertex 2 by +z, without a base buffer view.
inline GltfSample morph_sample() {
  GltfSample sample = square_sample();
  const auto indices = sample.add_view(std::vector<std::uint16_t>{2});
  const auto values = sample.add_view(std::vector<float>{0, 0, 0.5F});
  const auto target = sample.add("accessors", {{"componentType", 5126},
                                               {"count", 4},
                                               {"type", "VEC3"},
                                               {"sparse",
                                                {{"count", 1},
                                                 {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                                                 {"values", {{"bufferView", values}}}}}});
  sample.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", target}}};
  sample.json["meshes"][0]["extras"] = {{"targetNames", {"lift"}}};
  sample.json["meshes"][0]["weights"] = {0.25};
  return sample;
}

/// The square carried by two joints: "root" at x = 2 and "tip" below it; vertices 0 and 3 follow root alone, the others
/// half of each.
inline GltfSample skin_sample() {
  GltfSample sample = square_sample();
  std::vector<float> binds(32, 0.0F);
  for (std::size_t m = 0; m < 2; ++m) {
    for (std::size_t i = 0; i < 4; ++i) binds[16 * m + 5 * i] = 1;
  }
  binds[12] = -2;
  binds[16 + 12] = -3;
  auto& attributes = sample.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_0"] =
      sample.add_accessor(std::vector<std::uint8_t>{0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0}, "VEC4", 4, 5121);
  attributes["WEIGHTS_0"] = sample.add_accessor(
      std::vector<float>{1, 0, 0, 0, 0.5F, 0.5F, 0, 0, 0.5F, 0.5F, 0, 0, 1, 0, 0, 0}, "VEC4", 4, 5126);
  const auto matrices = sample.add_accessor(binds, "MAT4", 16, 5126);
  sample.add("nodes", {{"name", "root"}, {"translation", {2, 0, 0}}, {"children", {2}}});
  sample.add("nodes", {{"name", "tip"}, {"translation", {1, 0, 0}}});
  sample.json["nodes"][0]["skin"] = 0;
  sample.json["nodes"][0]["translation"] = {100, 0, 0};  // a skinned mesh's own node does not count
  sample.add("skins", {{"joints", {1, 2}}, {"inverseBindMatrices", matrices}});
  sample.json["scenes"][0]["nodes"] = {0, 1};
  return sample;
}

}  // namespace penpose::tests
