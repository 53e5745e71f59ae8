#include "core/io/gltf/read/compression/unpack_gltf.h"

#include <algorithm>
#include <cmath>
#include <draco/compression/expert_encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include "tests/support/models/gltf_sample.h"
#include "tests/support/shared_data.h"

namespace penpose::io {
namespace {

using Stream = std::vector<std::uint8_t>;

Stream packed_attributes(const void* data, std::size_t count, std::size_t stride) {
  Stream out(meshopt_encodeVertexBufferBound(count, stride));
  out.resize(meshopt_encodeVertexBuffer(out.data(), out.size(), data, count, stride));
  return out;
}

Stream packed_triangles(const std::vector<std::uint32_t>& corners, std::size_t vertices) {
  Stream out(meshopt_encodeIndexBufferBound(corners.size(), vertices));
  out.resize(meshopt_encodeIndexBuffer(out.data(), out.size(), corners.data(), corners.size()));
  return out;
}

Stream packed_sequence(const std::vector<std::uint32_t>& corners, std::size_t vertices) {
  Stream out(meshopt_encodeIndexSequenceBound(corners.size(), vertices));
  out.resize(meshopt_encodeIndexSequence(out.data(), out.size(), corners.data(), corners.size()));
  return out;
}

/// Puts a stream where the bytes of a view stand, as gltfpack writes it: the view itself lies in a buffer that holds
/// nothing.
void pack_view(tests::GltfSample& sample, std::size_t view, const Stream& stream, std::size_t count, std::size_t stride,
               const char* mode, const char* extension = "EXT_meshopt_compression") {
  const std::size_t place = sample.binary.size();
  sample.binary.insert(sample.binary.end(), stream.begin(), stream.end());
  while (sample.binary.size() % 4 != 0) sample.binary.push_back(0);
  sample.json["bufferViews"][view] = {{"buffer", 1},
                                      {"byteLength", count * stride},
                                      {"extensions",
                                       {{extension,
                                         {{"buffer", 0},
                                          {"byteOffset", place},
                                          {"byteLength", stream.size()},
                                          {"byteStride", stride},
                                          {"count", count},
                                          {"mode", mode}}}}}};
}

Stream finished(tests::GltfSample& sample, const char* extension = "EXT_meshopt_compression") {
  sample.set_buffer();
  sample.json["buffers"].push_back({{"byteLength", 1 << 20}, {"extensions", {{extension, {{"fallback", true}}}}}});
  sample.json["extensionsRequired"] = {extension};
  sample.json["extensionsUsed"] = {extension};
  return tests::GltfSample::glb_of(sample.json.dump(), sample.binary);
}

const std::vector<float> k_square = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};

void expect_square(const base::Result<document::Model>& model) {
  ASSERT_TRUE(model.ok()) << model.error().line();
  const auto positions = model->mesh->positions();
  ASSERT_EQ(positions.size(), 4U);
  for (std::size_t v = 0; v < 4; ++v) {
    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(static_cast<float>(positions[v][axis]), k_square[3 * v + axis]) << v;
  }
  ASSERT_EQ(model->mesh->triangle_count(), 2U);
}

TEST(UnpackGltf, PositionsAndTrianglesOfMeshoptAreThoseThatWerePacked) {
  for (const char* extension : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    for (const bool triangles : {true, false}) {
      tests::GltfSample sample = tests::square_sample();
      const std::vector<std::uint32_t> corners{0, 1, 2, 0, 2, 3};
      pack_view(sample, 0, packed_attributes(k_square.data(), 4, 12), 4, 12, "ATTRIBUTES", extension);
      pack_view(sample, 1, triangles ? packed_triangles(corners, 4) : packed_sequence(corners, 4), 6, 2,
                triangles ? "TRIANGLES" : "INDICES", extension);
      expect_square(read_gltf(finished(sample, extension)));
    }
  }
}

TEST(UnpackGltf, MorphTargetsOfMeshoptMove) {
  tests::GltfSample sample = tests::square_sample();
  std::vector<float> deltas(12, 0.0F);
  deltas[6 + 2] = 0.5F;
  const std::size_t target = sample.add_vec3(deltas);
  sample.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", target}}};
  pack_view(sample, sample.json["accessors"][target]["bufferView"], packed_attributes(deltas.data(), 4, 12), 4, 12,
            "ATTRIBUTES");
  const auto model = read_gltf(finished(sample));
  ASSERT_TRUE(model.ok()) << model.error().line();
  ASSERT_NE(model->shapes, nullptr);
  ASSERT_EQ(model->shapes->shapes()[0].vertices, (std::vector<std::uint32_t>{2}));
  EXPECT_EQ(model->shapes->shapes()[0].deltas[0], glm::vec3(0, 0, 0.5F));
}

TEST(UnpackGltf, BadMeshoptIsOneLineWithItsPlace) {
  const auto error_of = [](const auto& bend) {
    tests::GltfSample sample = tests::square_sample();
    pack_view(sample, 0, packed_attributes(k_square.data(), 4, 12), 4, 12, "ATTRIBUTES");
    auto& packed = sample.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"];
    bend(packed, sample);
    const auto model = read_gltf(finished(sample));
    EXPECT_FALSE(model.ok());
    if (model) return std::string();
    EXPECT_TRUE(model.error().place.starts_with("/bufferViews/0/extensions/EXT_meshopt_compression"))
        << model.error().line();
    EXPECT_FALSE(model.error().remedy.empty());
    return model.error().what;
  };
  using J = nlohmann::json;
  using S = tests::GltfSample;
  EXPECT_NE(error_of([](J& p, S&) { p["count"] = 1 << 30; }), "");
  EXPECT_NE(error_of([](J& p, S&) { p["byteLength"] = 3; }), "");
  EXPECT_NE(error_of([](J& p, S&) { p["byteOffset"] = 1 << 20; }), "");
  EXPECT_NE(error_of([](J& p, S&) { p["byteStride"] = 7; }), "");
  EXPECT_NE(error_of([](J& p, S&) { p["mode"] = "OTHER"; }), "");
  EXPECT_NE(error_of([](J& p, S&) { p["filter"] = "OCTAHEDRAL"; }), "");
  EXPECT_NE(error_of([](J& p, S&) { p["buffer"] = 9; }), "");
  EXPECT_NE(error_of([](J& p, S&) { p.erase("count"); }), "");
  const std::string newer = error_of([](J& p, S& sample) { sample.binary[p["byteOffset"].get<std::size_t>()] = 0xa1; });
  EXPECT_NE(newer.find("version 1"), std::string::npos) << newer;
}

/// The square as Draco packs it, one number of a unique id an attribute, in the order in which the encoder leaves it.
Stream draco_square(int method, int quantization) {
  draco::Mesh mesh;
  mesh.set_num_points(4);
  draco::GeometryAttribute positions;
  positions.Init(draco::GeometryAttribute::POSITION, nullptr, 3, draco::DT_FLOAT32, false, 12, 0);
  const int id = mesh.AddAttribute(positions, true, 4);
  mesh.attribute(id)->set_unique_id(7);
  for (std::uint32_t v = 0; v < 4; ++v) {
    mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(v), &k_square[3 * v]);
  }
  draco::GeometryAttribute joints;
  joints.Init(draco::GeometryAttribute::GENERIC, nullptr, 4, draco::DT_UINT8, false, 4, 0);
  const int second = mesh.AddAttribute(joints, true, 4);
  mesh.attribute(second)->set_unique_id(3);
  for (std::uint32_t v = 0; v < 4; ++v) {
    const std::uint8_t numbers[4] = {static_cast<std::uint8_t>(v), 0, 0, 255};
    mesh.attribute(second)->SetAttributeValue(draco::AttributeValueIndex(v), numbers);
  }
  for (const auto& t : {std::array<std::uint32_t, 3>{0, 1, 2}, std::array<std::uint32_t, 3>{0, 2, 3}}) {
    mesh.AddFace({draco::PointIndex(t[0]), draco::PointIndex(t[1]), draco::PointIndex(t[2])});
  }
  draco::ExpertEncoder encoder(mesh);
  encoder.SetEncodingMethod(method);
  if (quantization > 0) encoder.SetAttributeQuantization(id, quantization);
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeToBuffer(&buffer).ok());
  return {buffer.data(), buffer.data() + buffer.size()};
}

tests::GltfSample draco_sample(const Stream& stream) {
  tests::GltfSample sample;
  const std::size_t view = sample.add_view(stream);
  sample.add("accessors", {{"componentType", 5126}, {"count", 4}, {"type", "VEC3"}});
  sample.add("accessors", {{"componentType", 5123}, {"count", 6}, {"type", "SCALAR"}});
  sample.add("meshes",
             {{"name", "square"},
              {"primitives",
               {{{"attributes", {{"POSITION", 0}}},
                 {"indices", 1},
                 {"extensions",
                  {{"KHR_draco_mesh_compression", {{"bufferView", view}, {"attributes", {{"POSITION", 7}}}}}}}}}}});
  sample.add("nodes", {{"name", "square"}, {"mesh", 0}});
  sample.add("scenes", {{"nodes", {0}}});
  sample.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  return sample;
}

TEST(UnpackGltf, DracoGivesTheSquareByBothMethods) {
  for (const int method : {0, 1}) {
    for (const int bits : {0, 10}) {
      const auto model = draco_sample(draco_square(method, bits)).read();
      ASSERT_TRUE(model.ok()) << model.error().line();
      ASSERT_EQ(model->mesh->vertex_count(), 4U);
      ASSERT_EQ(model->mesh->triangle_count(), 2U);
      double area = 0;
      for (const auto& t : model->mesh->triangles()) {
        const auto p = model->mesh->positions();
        area += 0.5 * glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]).z;
      }
      EXPECT_NEAR(area, 1.0, bits == 0 ? 0.0 : 1e-6);
    }
  }
}

TEST(UnpackGltf, AMorphTargetOfADracoMeshMovesTheVerticesOfItsStream) {
  // The order of vertices stays by the first method.
  auto sample = draco_sample(draco_square(0, 0));
  std::vector<float> deltas(12, 0.0F);
  deltas[6 + 2] = 0.5F;
  sample.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", sample.add_vec3(deltas)}}};
  const auto model = sample.read();
  expect_square(model);
  EXPECT_EQ(model->shapes->shapes()[0].vertices, (std::vector<std::uint32_t>{2}));
}

TEST(UnpackGltf, PrimitivesThatShareAccessorsKeepTheirOwnStreams) {
  auto sample = draco_sample(draco_square(0, 0));
  auto moved = sample.json["meshes"][0]["primitives"][0];
  moved["extensions"]["KHR_draco_mesh_compression"]["bufferView"] = sample.add_view(draco_square(0, 4));
  sample.json["meshes"][0]["primitives"].push_back(moved);
  const auto model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_EQ(model->mesh->vertex_count(), 8U);
  EXPECT_EQ(model->mesh->triangle_count(), 4U);
}

TEST(UnpackGltf, BadDracoIsOneLineWithItsPlace) {
  const Stream whole = draco_square(1, 10);
  const auto error_of = [](tests::GltfSample sample) {
    const base::Error error = sample.error();
    EXPECT_TRUE(error.place.starts_with("/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression"))
        << error.line();
    EXPECT_FALSE(error.remedy.empty());
    return error.what;
  };
  for (std::size_t length = 1; length < whole.size(); ++length) {
    EXPECT_NE(error_of(draco_sample(Stream(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)))), "");
  }
  auto missing = draco_sample(whole);
  missing.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"]["attributes"]["POSITION"] = 1;
  EXPECT_NE(error_of(missing).find("no attribute 1"), std::string::npos);
  auto other = draco_sample(whole);
  other.json["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"]["attributes"]["POSITION"] = 3;
  EXPECT_NE(error_of(other), "");
  Stream old = whole;
  old[6] = 1;
  EXPECT_NE(error_of(draco_sample(old)).find("2.1"), std::string::npos);
  // A number of triangles that no memory holds.
  Stream huge = draco_square(0, 0);
  const std::uint8_t many[5] = {0xff, 0xff, 0xff, 0xff, 0x04};
  huge.erase(huge.begin() + 11);
  huge.insert(huge.begin() + 11, many, many + 5);
  EXPECT_NE(error_of(draco_sample(huge)).find("far more"), std::string::npos);
}

TEST(UnpackGltf, PlainDataBesideADracoStreamIsTaken) {
  tests::GltfSample sample = tests::square_sample();
  sample.json["meshes"][0]["primitives"][0]["extensions"] = {
      {"KHR_draco_mesh_compression", {{"bufferView", 0}, {"attributes", {{"POSITION", 0}}}}}};
  expect_square(sample.read());
}

class SharedRigs : public testing::TestWithParam<std::array<const char*, 2>> {};

TEST_P(SharedRigs, CompressedFilesOpen) {
  const auto path = tests::shared_dir() / "cases" / "rigs" / GetParam()[0] / GetParam()[1];
  if (!std::filesystem::exists(path)) GTEST_SKIP();
  const auto model = read_gltf(tests::read_file(path));
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_GT(model->mesh->triangle_count(), 0U);
}

// Its stream is four zeros.
TEST(SharedDraco, AStreamThatIsNoneIsNamed) {
  const auto path = tests::shared_dir() / "cases" / "rigs" / "draco_called_damaged" / "draco.gltf";
  if (!std::filesystem::exists(path)) GTEST_SKIP();
  const auto model = read_gltf(tests::read_file(path));
  ASSERT_FALSE(model.ok());
  EXPECT_TRUE(model.error().place.ends_with("KHR_draco_mesh_compression")) << model.error().line();
  EXPECT_NE(model.error().remedy.find("without compression"), std::string::npos) << model.error().line();
}

INSTANTIATE_TEST_SUITE_P(Files, SharedRigs,
                         testing::Values(std::array{"meshopt_refused", "meshopt.glb"},
                                         std::array{"channel_without_node", "simple_nonode.glb"},
                                         std::array{"channel_without_node", "simple_pointer_mixed.glb"},
                                         std::array{"non_manifold_fin", "simple_fin.glb"}));

}  // namespace
}  // namespace penpose::io
