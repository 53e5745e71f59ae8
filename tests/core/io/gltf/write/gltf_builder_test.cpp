#include "core/io/gltf/write/internal/gltf_builder.h"

#include <gtest/gtest.h>

#include "core/io/gltf/read/internal/gltf_accessor.h"

namespace penpose::io {
namespace {

TEST(GltfBuilder, AccessorsReadBack) {
  GltfBuilder builder;
  builder.root["asset"] = {{"version", "2.0"}};
  const std::vector<float> numbers = {1, 2, 3, -1, 5, 0};
  const std::vector<std::uint32_t> few = {0, 2, 1};
  const std::vector<std::uint32_t> many = {0, 65535, 1};
  builder.add_floats(numbers, "VEC3", BufferUse::vertices, true);
  builder.add_indices(few);
  builder.add_indices(many);
  EXPECT_EQ(builder.root["accessors"][0]["min"], json::Json({-1, 2, 0}));
  EXPECT_EQ(builder.root["accessors"][0]["max"], json::Json({1, 5, 3}));
  EXPECT_EQ(builder.root["accessors"][1]["componentType"], 5123);
  EXPECT_EQ(builder.root["accessors"][2]["componentType"], 5125);
  const auto bytes = builder.finish();
  ASSERT_TRUE(bytes.ok());
  auto document = open_gltf(*bytes, {});
  ASSERT_TRUE(document.ok()) << document.error().line();
  EXPECT_EQ(read_elements(*document, 0, {})->base, numbers);
  EXPECT_EQ(*read_indices(*document, 1), few);
  EXPECT_EQ(*read_indices(*document, 2), many);
}

TEST(GltfBuilder, DisplacementsAreSparseWhereThatIsSmaller) {
  GltfBuilder builder;
  builder.root["asset"] = {{"version", "2.0"}};
  const std::vector<std::uint32_t> elements = {1, 3};
  const std::vector<float> values = {0, 0, 2, 0, -1, 0};
  builder.add_displacements(10, elements, values, false, true);
  builder.add_displacements(2, std::vector<std::uint32_t>{0, 1}, values, false, true);
  builder.add_displacements(2, std::vector<std::uint32_t>{0, 1}, values, true, true);
  builder.add_displacements(2, {}, {}, false, true);
  const json::Json& accessors = builder.root["accessors"];
  EXPECT_TRUE(accessors[0].contains("sparse"));
  EXPECT_EQ(accessors[0]["max"], json::Json({0, 0, 2}));
  EXPECT_FALSE(accessors[1].contains("sparse"));
  EXPECT_TRUE(accessors[2].contains("sparse"));
  EXPECT_FALSE(accessors[3].contains("bufferView"));
  const auto bytes = builder.finish();
  ASSERT_TRUE(bytes.ok());
  auto document = open_gltf(*bytes, {});
  ASSERT_TRUE(document.ok()) << document.error().line();
  EXPECT_EQ(read_elements(*document, 0, {})->sparse, elements);
  EXPECT_EQ(read_elements(*document, 1, {})->dense(), values);
  EXPECT_EQ(read_elements(*document, 2, {})->dense(), values);
  EXPECT_EQ(read_elements(*document, 3, {})->dense(), std::vector<float>(6, 0.0F));
}

}  // namespace
}  // namespace penpose::io
