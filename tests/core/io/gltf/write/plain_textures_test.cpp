#include "core/io/gltf/write/plain_textures.h"

#include <gtest/gtest.h>
#include <webp/encode.h>

#include "core/picture/image.h"
#include "tests/support/models/gltf_sample.h"

namespace penpose::io {
namespace {

std::vector<std::uint8_t> webp() {
  const std::vector<std::uint8_t> pixels{255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 9, 8, 7, 255};
  std::uint8_t* out = nullptr;
  const std::size_t size = WebPEncodeLosslessRGBA(pixels.data(), 2, 2, 8, &out);
  std::vector<std::uint8_t> bytes(out, out + size);
  WebPFree(out);
  return bytes;
}

nlohmann::json json_of(const std::vector<std::uint8_t>& glb) {
  const std::size_t size = glb[12] | glb[13] << 8 | glb[14] << 16;
  return nlohmann::json::parse(glb.begin() + 20, glb.begin() + 20 + static_cast<std::ptrdiff_t>(size));
}

TEST(PlainTextures, WebpBecomesPngAndTheExtensionGoes) {
  tests::GltfSample sample = tests::square_sample();
  const std::size_t view = sample.add_view(webp());
  sample.add("images", {{"bufferView", view}, {"mimeType", "image/webp"}});
  sample.add("textures", {{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}});
  sample.json["extensionsUsed"] = {"EXT_texture_webp", "KHR_materials_unlit"};
  sample.json["extensionsRequired"] = {"EXT_texture_webp"};
  std::vector<std::string> notes;
  const auto plain = with_plain_textures(sample.glb(), notes);
  ASSERT_TRUE(plain) << plain.error().line();
  EXPECT_TRUE(notes.empty());
  const auto json = json_of(*plain);
  EXPECT_EQ(json["images"][0]["mimeType"], "image/png");
  EXPECT_EQ(json["textures"][0], (nlohmann::json{{"source", 0}}));
  EXPECT_EQ(json["extensionsUsed"], (nlohmann::json{"KHR_materials_unlit"}));
  EXPECT_FALSE(json.contains("extensionsRequired"));
  const auto& png = json["bufferViews"][json["images"][0]["bufferView"].get<std::size_t>()];
  const std::size_t text = json_of(*plain).dump().size();
  const std::size_t start = 20 + (text + 3) / 4 * 4 + 8 + png["byteOffset"].get<std::size_t>();
  const auto image = picture::decode_png(base::Bytes(*plain).subspan(start, png["byteLength"].get<std::size_t>()));
  ASSERT_TRUE(image) << image.error().line();
  EXPECT_EQ(image->width, 2);
  EXPECT_EQ(image->at(1, 1)[0], 9);
  const auto read = read_gltf(*plain);
  ASSERT_TRUE(read.ok()) << read.error().line();
  EXPECT_EQ(read->mesh->vertex_count(), 4U);
}

TEST(PlainTextures, AFileWithoutWebpKeepsWhatItHas) {
  const auto bytes = tests::skin_sample().glb();
  std::vector<std::string> notes;
  const auto plain = with_plain_textures(bytes, notes).value();
  EXPECT_EQ(json_of(plain), json_of(bytes));
}

}  // namespace
}  // namespace penpose::io
