#include "core/io/gltf/write/patch/plain_primitives.h"

#include <draco/compression/expert_encode.h>
#include <draco/mesh/mesh.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include "tests/support/models/textured_trunk.h"

namespace penpose::io {
namespace {

using PlainJson = nlohmann::json;
using PlainBytes = std::vector<std::uint8_t>;

constexpr const char* k_draco = "KHR_draco_mesh_compression";
constexpr const char* k_meshopt = "EXT_meshopt_compression";

/// The trunk's points and triangles as a Draco stream of two attributes: positions and, of 8 bits, VEC3 colours.
PlainBytes draco_trunk(int method, int bits) {
  const tests::Trunk trunk = tests::make_trunk();
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
  EXPECT_TRUE(encoder.EncodeToBuffer(&buffer).ok());
  return {buffer.data(), buffer.data() + buffer.size()};
}

/// The trunk packed by Draco, and far away as a mesh of its own once more.
tests::GltfSample packed_trunk(int method, int bits) {
  tests::GltfSample sample;
  const tests::Trunk trunk = tests::make_trunk();
  for (int i = 0; i < 2; ++i) {
    const std::size_t view = sample.add_view(draco_trunk(method, bits));
    const auto of_points = [&](int type, bool normalized) {
      PlainJson accessor = {{"componentType", type}, {"count", trunk.canvas->positions().size()}, {"type", "VEC3"}};
      if (normalized) accessor["normalized"] = true;
      return sample.add("accessors", accessor);
    };
    const std::size_t positions = of_points(5126, false);
    sample.json["accessors"][positions]["min"] = {-9, -9, -9};
    sample.json["accessors"][positions]["max"] = {9, 9, 9};
    sample.json["accessors"][positions]["name"] = "places";
    const std::size_t colours = of_points(5121, true);
    const std::size_t corners = sample.add(
        "accessors",
        {{"componentType", 5125}, {"count", 3 * trunk.canvas->mesh().triangles().size()}, {"type", "SCALAR"}});
    sample.add("meshes", {{"name", i == 0 ? "trunk" : "other"},
                          {"primitives",
                           {{{"attributes", {{"POSITION", positions}, {"COLOR_0", colours}}},
                             {"indices", corners},
                             {"extensions",
                              {{k_draco, {{"bufferView", view}, {"attributes", {{"POSITION", 4}, {"COLOR_0", 9}}}}},
                               {"ACME_hair", {{"strands", 3}}}}}}}}});
    sample.add("nodes", {{"name", i == 0 ? "trunk" : "other"}, {"mesh", i}});
  }
  sample.json["nodes"][1]["translation"] = {50, 0, 0};
  sample.add("scenes", {{"nodes", {0, 1}}});
  sample.json["extensionsUsed"] = {k_draco, "ACME_hair"};
  sample.json["extensionsRequired"] = {k_draco};
  return sample;
}

TEST(PlainPrimitives, OnlyTheDracoStreamThatGotATargetIsUnpacked) {
  for (const int method : {0, 1}) {
    const PlainBytes bytes = packed_trunk(method, method == 0 ? 0 : 14).glb();
    document::Model model = tests::with_curl(tests::read_glb(bytes));
    model.pose[0] = 0.5;
    const PlainBytes written = write_glb(model).value();
    tests::expect_kept(bytes, written, {"/meshes/0/primitives/0/extensions", "/accessors/0"});
    const PlainJson was = tests::parts_of(bytes).json;
    const PlainJson json = tests::parts_of(written).json;
    const PlainJson& primitive = json["meshes"][0]["primitives"][0];
    EXPECT_EQ(primitive["extensions"], PlainJson({{"ACME_hair", {{"strands", 3}}}}));
    EXPECT_EQ(json["meshes"][1], was["meshes"][1]);
    EXPECT_EQ(json["extensionsRequired"], was["extensionsRequired"]) << "the other one still needs it";
    for (const std::size_t accessor : {0U, 1U, 2U}) EXPECT_TRUE(json["accessors"][accessor].contains("bufferView"));
    for (const std::size_t accessor : {3U, 4U, 5U}) EXPECT_EQ(json["accessors"][accessor], was["accessors"][accessor]);
    EXPECT_EQ(json["accessors"][0]["name"], "places");
    EXPECT_NE(json["accessors"][0]["max"], was["accessors"][0]["max"]) << "its bounds are those of its numbers";
    const PlainJson& colours = json["bufferViews"][json["accessors"][1]["bufferView"].get<std::size_t>()];
    EXPECT_EQ(colours["byteStride"], 4) << "elements of 3 bytes start at multiples of 4";
    const document::Model again = tests::read_glb(written);
    EXPECT_EQ(document::state_hash(again), document::state_hash(model));
    EXPECT_EQ(write_glb(again).value(), written);
  }
}

TEST(PlainPrimitives, AnExtensionThatNothingUsesIsNoLongerAskedFor) {
  tests::GltfSample sample = packed_trunk(1, 14);
  sample.json["meshes"].erase(1);
  sample.json["nodes"].erase(1);
  sample.json["scenes"][0]["nodes"] = {0};
  const PlainBytes bytes = sample.glb();
  EXPECT_EQ(write_glb(tests::read_glb(bytes)).value(), bytes);
  const document::Model model = tests::with_curl(tests::read_glb(bytes));
  const PlainJson json = tests::parts_of(write_glb(model).value()).json;
  EXPECT_FALSE(json.contains("extensionsRequired"));
  EXPECT_EQ(json["extensionsUsed"], PlainJson({"ACME_hair"}));
  EXPECT_EQ(document::state_hash(tests::read_glb(write_glb(model).value())), document::state_hash(model));
}

TEST(PlainPrimitives, PosingADracoFileLeavesItPacked) {
  tests::GltfSample sample = packed_trunk(0, 0);
  const std::size_t count = sample.json["accessors"][0]["count"];
  std::vector<float> lift(3 * count, 0.0F);
  lift[2] = 0.5F;
  sample.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", sample.add_vec3(lift)}}};
  sample.json["meshes"][0]["weights"] = {0};
  const PlainBytes bytes = sample.glb();
  document::Model model = tests::read_glb(bytes);
  model.pose[0] = 0.5;
  const PlainBytes posed = write_glb(model).value();
  tests::expect_kept(bytes, posed, {"/meshes/0/weights"});
  EXPECT_EQ(tests::parts_of(posed).binary.size(), tests::parts_of(bytes).binary.size());
}

/// Targets of quantised positions are of another kind, and what they are added to stays.
TEST(PlainPrimitives, QuantisedMeshesKeepTheirNumbers) {
  tests::GltfSample sample = tests::textured_trunk();
  const tests::Trunk trunk = tests::make_trunk();
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
  // Metres are 4096 steps; the target moves by steps too.
  sample.json["nodes"][1]["scale"] = {1.0 / 4096, 1.0 / 4096, 1.0 / 4096};
  sample.json["extensionsUsed"].push_back("KHR_mesh_quantization");
  sample.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  const PlainBytes bytes = sample.glb();
  document::Model model = tests::with_curl(tests::read_glb(bytes));
  model.pose[1] = 0.5;
  const PlainBytes written = write_glb(model).value();
  tests::expect_kept(bytes, written, {"/animations/0/samplers/0/output", "/animations/1/samplers/0/output"});
  const PlainJson json = tests::parts_of(written).json;
  EXPECT_EQ(json["extensionsRequired"], PlainJson({"KHR_mesh_quantization"}));
  const PlainJson& target = json["meshes"][0]["primitives"][0]["targets"][1];
  EXPECT_EQ(json["accessors"][target["POSITION"].get<std::size_t>()]["componentType"], 5126);
  EXPECT_EQ(document::state_hash(tests::read_glb(written)), document::state_hash(model));
}

TEST(PlainPrimitives, ViewsThatMeshoptHasPackedStayPackedBesideNewTargets) {
  tests::GltfSample sample = tests::textured_trunk();
  const auto& attributes = sample.json["meshes"][0]["primitives"][0]["attributes"];
  const std::size_t count = sample.json["accessors"][0]["count"];
  for (const char* name : {"POSITION", "NORMAL"}) {
    const std::size_t view = sample.json["accessors"][attributes[name].get<std::size_t>()]["bufferView"];
    auto& plain = sample.json["bufferViews"][view];
    const std::uint8_t* from = sample.binary.data() + plain["byteOffset"].get<std::size_t>();
    PlainBytes packed(meshopt_encodeVertexBufferBound(count, 12));
    packed.resize(meshopt_encodeVertexBuffer(packed.data(), packed.size(), from, count, 12));
    const std::size_t stream = sample.add_view(packed);
    PlainJson where = sample.json["bufferViews"][stream];
    sample.json["bufferViews"].erase(stream);
    where.update({{"byteStride", 12}, {"count", count}, {"mode", "ATTRIBUTES"}});
    sample.json["bufferViews"][view] = {
        {"buffer", 1}, {"byteLength", 12 * count}, {"byteStride", 12}, {"extensions", {{k_meshopt, where}}}};
  }
  sample.set_buffer();
  sample.json["buffers"].push_back({{"byteLength", 24 * count}, {"extensions", {{k_meshopt, {{"fallback", true}}}}}});
  sample.json["extensionsUsed"].push_back(k_meshopt);
  sample.json["extensionsRequired"] = {k_meshopt};
  const PlainBytes bytes = tests::GltfSample::glb_of(sample.json.dump(), sample.binary);
  document::Model model = tests::with_curl(tests::read_glb(bytes));
  model.pose[1] = 0.5;
  const PlainBytes written = write_glb(model).value();
  tests::expect_kept(bytes, written, {"/animations/0/samplers/0/output", "/animations/1/samplers/0/output"});
  EXPECT_EQ(document::state_hash(tests::read_glb(written)), document::state_hash(model));
}

}  // namespace
}  // namespace penpose::io
