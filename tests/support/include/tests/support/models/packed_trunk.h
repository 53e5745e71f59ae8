#pragma once

#include <array>
#include <cstdint>
#include <draco/compression/expert_encode.h>
#include <draco/mesh/mesh.h>
#include <vector>

#include "tests/support/models/gltf_sample.h"
#include "tests/support/models/sketched_models.h"

namespace penpose::tests {

/// The trunk's points and triangles as a Draco stream of two attributes: positions and, of 8 bits, VEC3 colours.
inline std::vector<std::uint8_t> draco_trunk(int method, int bits) {
  const Trunk trunk = make_trunk();
  const auto points = trunk.canvas->positions();
  draco::Mesh mesh;
  mesh.set_num_points(static_cast<std::uint32_t>(points.size()));
  const auto add = [&](draco::GeometryAttribute::Type type, draco::DataType data, int size, std::uint32_t id) {
    draco::GeometryAttribute attribute;
    attribute.Init(type, nullptr, 3, data, false, size, 0);
    const int number = mesh.AddAttribute(attribute, true, static_cast<std::uint32_t>(points.size()));
    mesh.attribute(number)->set_unique_id(id);
    return number;
  };
  const int positions = add(draco::GeometryAttribute::POSITION, draco::DT_FLOAT32, 12, 4);
  const int colours = add(draco::GeometryAttribute::COLOR, draco::DT_UINT8, 3, 9);
  for (std::uint32_t v = 0; v < points.size(); ++v) {
    const std::array<float, 3> place{static_cast<float>(points[v].x), static_cast<float>(points[v].y),
                                     static_cast<float>(points[v].z)};
    const std::array<std::uint8_t, 3> colour{static_cast<std::uint8_t>(v % 251), 7, 200};
    mesh.attribute(positions)->SetAttributeValue(draco::AttributeValueIndex(v), place.data());
    mesh.attribute(colours)->SetAttributeValue(draco::AttributeValueIndex(v), colour.data());
  }
  for (const auto& t : trunk.canvas->mesh().triangles())
    mesh.AddFace({draco::PointIndex(t[0]), draco::PointIndex(t[1]), draco::PointIndex(t[2])});
  draco::ExpertEncoder encoder(mesh);
  encoder.SetEncodingMethod(method);
  if (bits > 0) encoder.SetAttributeQuantization(positions, bits);
  draco::EncoderBuffer buffer;
  if (!encoder.EncodeToBuffer(&buffer).ok()) return {};
  return {buffer.data(), buffer.data() + buffer.size()};
}

/// The trunk packed by Draco, and far away as a mesh of its own once more.
inline GltfSample packed_trunk(int method, int bits) {
  GltfSample sample;
  const Trunk trunk = make_trunk();
  for (int i = 0; i < 2; ++i) {
    const std::size_t view = sample.add_view(draco_trunk(method, bits));
    const auto of_points = [&](int type, bool normalized) {
      nlohmann::json accessor = {
          {"componentType", type}, {"count", trunk.canvas->positions().size()}, {"type", "VEC3"}};
      if (normalized) accessor["normalized"] = true;
      return sample.add("accessors", accessor);
    };
    const std::size_t positions = of_points(5126, false);
    // Bounds that hold whatever the stream rounds to.
    sample.json["accessors"][positions]["min"] = {-9, -9, -9};
    sample.json["accessors"][positions]["max"] = {9, 9, 9};
    sample.json["accessors"][positions]["name"] = "places";
    const std::size_t colours = of_points(5121, true);
    const std::size_t corners = sample.add(
        "accessors",
        {{"componentType", 5125}, {"count", 3 * trunk.canvas->mesh().triangles().size()}, {"type", "SCALAR"}});
    sample.add(
        "meshes",
        {{"name", i == 0 ? "trunk" : "other"},
         {"primitives",
          {{{"attributes", {{"POSITION", positions}, {"COLOR_0", colours}}},
            {"indices", corners},
            {"extensions",
             {{"KHR_draco_mesh_compression", {{"bufferView", view}, {"attributes", {{"POSITION", 4}, {"COLOR_0", 9}}}}},
              {"ACME_hair", {{"strands", 3}}}}}}}}});
    sample.add("nodes", {{"name", i == 0 ? "trunk" : "other"}, {"mesh", i}});
  }
  sample.json["nodes"][1]["translation"] = {50, 0, 0};
  sample.add("scenes", {{"nodes", {0, 1}}});
  sample.json["extensionsUsed"] = {"KHR_draco_mesh_compression", "ACME_hair"};
  sample.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  return sample;
}

}  // namespace penpose::tests
