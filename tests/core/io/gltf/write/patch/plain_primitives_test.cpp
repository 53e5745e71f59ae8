#include "core/io/gltf/write/patch/plain_primitives.h"

#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include "tests/support/file_parts.h"
#include "tests/support/models/packed_trunk.h"
#include "tests/support/models/textured_trunk.h"

namespace penpose::io {
namespace {

using PlainJson = nlohmann::json;
using PlainBytes = std::vector<std::uint8_t>;

constexpr const char* k_meshopt = "EXT_meshopt_compression";

TEST(PlainPrimitives, OnlyTheDracoStreamThatGotATargetIsUnpacked) {
  for (const int method : {0, 1}) {
    const PlainBytes bytes = tests::packed_trunk(method, method == 0 ? 0 : 14).glb();
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
  tests::GltfSample sample = tests::packed_trunk(1, 14);
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
  tests::GltfSample sample = tests::packed_trunk(0, 0);
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
  tests::GltfSample sample = tests::quantised_trunk();
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
