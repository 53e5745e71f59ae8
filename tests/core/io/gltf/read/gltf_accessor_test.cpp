#include "core/io/gltf/read/internal/gltf_accessor.h"

#include <gtest/gtest.h>

#include "tests/support/models/gltf_sample.h"

namespace penpose::io {
namespace {

/// Reads accessor 0 of the morph sample after a change, by the rule.
base::Result<Elements> read_bent(const char* pointer, const nlohmann::json& value, const ElementRule& rule = {},
                                 int accessor = 0) {
  tests::GltfSample sample = tests::morph_sample();
  if (*pointer != '\0') sample.json[nlohmann::json::json_pointer(pointer)] = value;
  const auto bytes = sample.glb();
  auto document = open_gltf(bytes, {});
  if (!document) return document.error();
  return read_elements(*document, accessor, rule);
}
std::string place(const char* pointer, const nlohmann::json& value, const ElementRule& rule = {}, int accessor = 0) {
  const auto elements = read_bent(pointer, value, rule, accessor);
  return elements ? "(no error)" : elements.error().place;
}

TEST(GltfAccessor, ReadsFloats) {
  const auto elements = read_bent("", nullptr);
  ASSERT_TRUE(elements.ok()) << elements.error().line();
  EXPECT_EQ(elements->count, 4U);
  EXPECT_EQ(elements->dense(), (std::vector<float>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}));
}

TEST(GltfAccessor, OneElementTooManyIsRefused) {
  const auto elements = read_bent("/accessors/0/count", 5);  // the bytes are there, but belong to the next view
  ASSERT_FALSE(elements.ok());
  EXPECT_EQ(elements.error().place, "/accessors/0");
}

TEST(GltfAccessor, SparseWithoutABaseIsZeroElsewhere) {
  const auto elements = read_bent("", nullptr, {}, 2);
  ASSERT_TRUE(elements.ok()) << elements.error().line();
  EXPECT_FALSE(elements->has_base);
  EXPECT_EQ(elements->sparse, std::vector<std::uint32_t>{2});
  EXPECT_EQ(elements->dense(), (std::vector<float>{0, 0, 0, 0, 0, 0, 0, 0, 0.5F, 0, 0, 0}));
}

TEST(GltfAccessor, SparseFaultsAreNamed) {
  const auto bent = [](const char* member, const nlohmann::json& value) {
    return place((std::string("/accessors/2/sparse/") + member).c_str(), value, {}, 2);
  };
  EXPECT_EQ(bent("count", 5), "/accessors/2/sparse/count");
  EXPECT_EQ(bent("count", 2), "/accessors/2/sparse/indices");
  EXPECT_EQ(bent("indices/componentType", 5126), "/accessors/2/sparse/indices/componentType");
  EXPECT_EQ(bent("indices/byteOffset", 4096), "/accessors/2/sparse/indices");
  EXPECT_EQ(bent("values/byteOffset", 4), "/accessors/2/sparse/values");
  EXPECT_EQ(bent("values/bufferView", 2), "/accessors/2/sparse/values");
}

TEST(GltfAccessor, OtherTypesThanAskedForAreRefused) {
  EXPECT_EQ(place("/accessors/0/type", "VEC4"), "/accessors/0/type");
  EXPECT_EQ(place("/accessors/0/componentType", 5124), "/accessors/0/componentType");
  EXPECT_EQ(place("/accessors/0/componentType", 5121, {.float_only = true}), "/accessors/0/componentType");
  EXPECT_EQ(place("", nullptr, {.count = 3}), "/accessors/0/count");
}

TEST(GltfAccessor, ViewsThatLeaveTheirBufferAreRefused) {
  EXPECT_EQ(place("/bufferViews/0/byteOffset", 1 << 30), "/bufferViews/0");
  EXPECT_EQ(place("/bufferViews/0/byteLength", std::int64_t{1} << 40), "/bufferViews/0");
  EXPECT_EQ(place("/bufferViews/0/byteLength", 47), "/accessors/0");
  EXPECT_EQ(place("/accessors/0/byteOffset", std::int64_t{1} << 40), "/accessors/0");
  EXPECT_EQ(place("/accessors/0/count", 0x7fffffff), "/accessors/0");
  EXPECT_EQ(place("/bufferViews/0/byteStride", 8), "/bufferViews/0/byteStride");
  EXPECT_EQ(place("/bufferViews/0/byteStride", 252), "/accessors/0");
}

TEST(GltfAccessor, HugeCountsWithoutBytesRunOutOfBudget) {
  tests::GltfSample sample = tests::square_sample();
  sample.add("accessors", {{"componentType", 5126}, {"count", 0x7fffffff}, {"type", "VEC3"}});
  const auto bytes = sample.glb();
  auto document = open_gltf(bytes, {});
  ASSERT_TRUE(document.ok());
  const auto zeros = read_elements(*document, 2, {});
  ASSERT_FALSE(zeros.ok());
  EXPECT_EQ(zeros.error().place, "/accessors/2");
  EXPECT_EQ(read_elements(*document, 2, {.needs_data = true, .stays_sparse = true}).error().place, "/accessors/2");
}

TEST(GltfAccessor, NormalizedIntegersAndStrides) {
  tests::GltfSample sample = tests::square_sample();
  const auto view = sample.add_view(std::vector<std::int8_t>{127, -128, 0, 99, -127, 64, 1, 99});
  sample.json["bufferViews"][view]["byteStride"] = 4;
  sample.add("accessors",
             {{"bufferView", view}, {"componentType", 5120}, {"normalized", true}, {"count", 2}, {"type", "VEC3"}});
  const auto bytes = sample.glb();
  auto document = open_gltf(bytes, {});
  ASSERT_TRUE(document.ok());
  const auto elements = read_elements(*document, 2, {});
  ASSERT_TRUE(elements.ok()) << elements.error().line();
  EXPECT_EQ(elements->base,
            (std::vector<float>{1, -1, 0, -1, static_cast<float>(64.0 / 127), static_cast<float>(1.0 / 127)}));
}

TEST(GltfAccessor, IndicesAreUnsignedIntegersWithData) {
  const auto indices = [](const char* pointer, const nlohmann::json& value) {
    tests::GltfSample sample = tests::square_sample();
    sample.json[nlohmann::json::json_pointer(pointer)] = value;
    const auto bytes = sample.glb();
    auto document = open_gltf(bytes, {});
    if (!document) return document.error().place;
    const auto read = read_indices(*document, 1);
    return read ? std::to_string(read->size()) : read.error().place;
  };
  EXPECT_EQ(indices("/asset/x", 0), "6");
  EXPECT_EQ(indices("/accessors/1/componentType", 5122), "/accessors/1/componentType");
  EXPECT_EQ(indices("/accessors/1/componentType", 5126), "/accessors/1/componentType");
  EXPECT_EQ(indices("/accessors/1/type", "VEC2"), "/accessors/1/type");
  EXPECT_EQ(indices("/accessors/1/count", 7), "/accessors/1");
}

}  // namespace
}  // namespace penpose::io
