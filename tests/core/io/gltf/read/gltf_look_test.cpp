#include <algorithm>
#include <gtest/gtest.h>

#include "core/document/look.h"
#include "core/document/source_file.h"
#include "tests/support/models/gltf_sample.h"
#include "tests/support/shared_data.h"

namespace penpose::io {
namespace {

using document::AlphaMode;
using document::Wrap;

void add_word(std::vector<std::uint8_t>& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

/// The head of a PNG picture of that size, with an end and nothing in between: nobody unpacks it here.
std::vector<std::uint8_t> png(std::uint32_t width, std::uint32_t height, bool whole = true) {
  std::vector<std::uint8_t> bytes{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  add_word(bytes, 13);
  for (const char c : {'I', 'H', 'D', 'R'}) bytes.push_back(static_cast<std::uint8_t>(c));
  add_word(bytes, width);
  add_word(bytes, height);
  bytes.insert(bytes.end(), {8, 6, 0, 0, 0});
  add_word(bytes, 0);
  if (!whole) return bytes;
  add_word(bytes, 0);
  for (const char c : {'I', 'E', 'N', 'D'}) bytes.push_back(static_cast<std::uint8_t>(c));
  add_word(bytes, 0);
  return bytes;
}

/// The square with coordinates and one material whose base colour is this picture.
tests::GltfSample textured(const std::vector<std::uint8_t>& picture) {
  tests::GltfSample sample = tests::square_sample();
  auto& primitive = sample.json["meshes"][0]["primitives"][0];
  primitive["attributes"]["TEXCOORD_0"] =
      sample.add_accessor(std::vector<float>{0, 1, 1, 1, 1, 0, 0, 0}, "VEC2", 2, 5126);
  primitive["material"] = 0;
  sample.add("images", {{"name", "skin"}, {"mimeType", "image/png"}, {"bufferView", sample.add_view(picture)}});
  sample.add("textures", {{"source", 0}});
  sample.add("materials", {{"name", "face"},
                           {"pbrMetallicRoughness",
                            {{"baseColorFactor", {1, 0.5, 0.25, 1}}, {"baseColorTexture", {{"index", 0}}}}}});
  return sample;
}

std::size_t notes_with(const document::Model& model, const std::string& word) {
  return static_cast<std::size_t>(std::count_if(model.notes.begin(), model.notes.end(), [&](const std::string& note) {
    return note.find(word) != std::string::npos;
  }));
}

TEST(GltfLook, APictureLiesOnTheSurfaceAsTheFileSays) {
  auto sample = textured(png(4, 4));
  sample.add("samplers", {{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}});
  sample.json["textures"][0]["sampler"] = 0;
  auto& material = sample.json["materials"][0];
  material["alphaMode"] = "MASK";
  material["alphaCutoff"] = 0.3;
  material["doubleSided"] = true;
  material["extensions"]["KHR_materials_unlit"] = nlohmann::json::object();
  material["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]["KHR_texture_transform"] = {
      {"offset", {0.5, 0.25}}, {"scale", {2, 3}}, {"rotation", 0.75}};
  const auto model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  ASSERT_NE(model->look, nullptr);
  const document::Look& look = *model->look;
  ASSERT_EQ(look.images.size(), 1U);
  EXPECT_EQ(look.images[0].mime_type, "image/png");
  const auto kept = look.images[0].bytes.view();
  EXPECT_EQ(std::vector<std::uint8_t>(kept.begin(), kept.end()), png(4, 4));
  ASSERT_EQ(look.surface_of.size(), 2U);
  const document::Surface& surface = look.surfaces[look.surface_of[0]];
  EXPECT_EQ(surface.name, "face");
  EXPECT_EQ(surface.base_color, (std::array<double, 4>{1, 0.5, 0.25, 1}));
  EXPECT_EQ(surface.alpha, AlphaMode::mask);
  EXPECT_EQ(surface.alpha_cutoff, 0.3);
  EXPECT_TRUE(surface.double_sided);
  EXPECT_TRUE(surface.unlit);
  ASSERT_TRUE(surface.texture.has_value());
  EXPECT_EQ(surface.texture->wrap_u, Wrap::clamp);
  EXPECT_EQ(surface.texture->wrap_v, Wrap::mirror);
  EXPECT_TRUE(surface.texture->nearest);
  EXPECT_EQ(surface.texture->offset, (std::array<double, 2>{0.5, 0.25}));
  EXPECT_EQ(surface.texture->scale, (std::array<double, 2>{2, 3}));
  EXPECT_EQ(surface.texture->rotation, 0.75);
  ASSERT_EQ(look.coordinates[0].size(), 4U);
  EXPECT_EQ(look.coordinates[0][2], (std::array<float, 2>{1, 0}));
  EXPECT_TRUE(look.coordinates[1].empty());
  EXPECT_TRUE(model->notes.empty());
}

TEST(GltfLook, WhatSaysNothingBeyondItsMaterialHasNoLook) {
  EXPECT_EQ(tests::square_sample().read()->look, nullptr);
  auto colored = tests::square_sample();
  colored.add("materials", {{"pbrMetallicRoughness", {{"baseColorFactor", {1, 0, 0, 1}}}}});
  colored.json["meshes"][0]["primitives"][0]["material"] = 0;
  EXPECT_EQ(colored.read()->look, nullptr);
}

TEST(GltfLook, PrimitivesThatShareVerticesKeepTheirMaterials) {
  auto sample = textured(png(4, 4));
  auto& primitives = sample.json["meshes"][0]["primitives"];
  primitives[0]["indices"] = sample.add_corners({0, 1, 1, 0, 1, 2});  // the first has no area
  primitives.push_back(primitives[0]);
  primitives[1]["indices"] = sample.add_corners({0, 2, 3});
  primitives[1]["material"] = sample.add("materials", {{"name", "lips"}});
  const auto model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_EQ(model->mesh->parts().size(), 1U);
  ASSERT_NE(model->look, nullptr);
  ASSERT_EQ(model->look->surface_of.size(), 2U);
  EXPECT_EQ(model->look->surfaces[model->look->surface_of[0]].name, "face");
  EXPECT_EQ(model->look->surfaces[model->look->surface_of[1]].name, "lips");
}

TEST(GltfLook, ColoursOfVerticesComeAsWholeOrBrokenNumbers) {
  auto sample = tests::square_sample();
  auto& attributes = sample.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["COLOR_0"] = sample.add_accessor(
      std::vector<std::uint8_t>{255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 0}, "VEC4", 4, 5121);
  sample.json["accessors"].back()["normalized"] = true;
  const auto whole = sample.read();
  ASSERT_NE(whole->look, nullptr);
  EXPECT_EQ(whole->look->colors[1], (std::array<float, 4>{0, 1, 0, 1}));
  EXPECT_EQ(whole->look->colors[3], (std::array<float, 4>{1, 1, 1, 0}));
  attributes["COLOR_0"] = sample.add_vec3({0.5F, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1});
  EXPECT_EQ(sample.read()->look->colors[0], (std::array<float, 4>{0.5F, 0, 0, 1}));
}

TEST(GltfLook, PicturesThatCannotBeShownLeaveTheModelGreyWithOneNote) {
  std::vector<std::uint8_t> ktx{0xab, 'K', 'T', 'X', ' ', '2', '0', 0xbb, '\r', '\n', 0x1a, '\n'};
  ktx.resize(80, 0);
  const std::vector<std::pair<std::vector<std::uint8_t>, std::string>> pictures{
      {png(16384, 16384), "16384 x 16384"},
      {png(4, 4, false), "cut off"},
      {ktx, "KTX2"},
      {{'G', 'I', 'F', '8', '9', 'a', 0, 0}, "no PNG, JPEG or WebP"},
      {png(0, 4), "0 x 4"}};
  for (const auto& [bytes, word] : pictures) {
    const auto model = textured(bytes).read();
    ASSERT_TRUE(model.ok()) << word << model.error().line();
    ASSERT_NE(model->look, nullptr) << word;
    EXPECT_TRUE(model->look->images.empty()) << word;
    EXPECT_EQ(model->look->undrawn.size(), 1U) << word;
    ASSERT_EQ(model->notes.size(), 1U) << word;
    EXPECT_EQ(notes_with(*model, word), 1U) << model->notes[0];
    EXPECT_EQ(notes_with(*model, "1 texture cannot be drawn and is grey: skin ("), 1U) << model->notes[0];
  }
  auto sample = textured(png(4, 4));
  sample.json["images"][0] = {{"uri", "gone/skin.png"}};
  sample.add("images", {{"bufferView", 99}});
  sample.add("textures", {{"source", 1}});
  sample.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 1}}}}}});
  auto& primitives = sample.json["meshes"][0]["primitives"];
  primitives[0]["indices"] = sample.add_corners({0, 1, 2});
  primitives.push_back(primitives[0]);
  primitives[1]["indices"] = sample.add_corners({0, 2, 3});
  primitives[1]["material"] = 1;
  const auto model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  ASSERT_EQ(model->notes.size(), 1U);
  EXPECT_EQ(notes_with(*model, "2 textures cannot be drawn"), 1U) << model->notes[0];
  EXPECT_EQ(notes_with(*model, "gone/skin.png (missing"), 1U) << model->notes[0];
  EXPECT_EQ(notes_with(*model, "image 1 ("), 1U) << model->notes[0];
}

TEST(GltfLook, APictureThatNamesItsOwnFileOrIsNestedIsOnlyGrey) {
  for (const char* uri :
       {"model.gltf", "data:image/png;base64,ZGF0YTppbWFnZS9wbmc7YmFzZTY0LEFB", "../model.gltf", "."}) {
    auto sample = textured(png(4, 4));
    sample.json["images"][0] = {{"uri", uri}};
    const auto bytes = sample.glb();
    const FileResolver itself = [&](const std::string&) { return base::Result<std::vector<std::uint8_t>>(bytes); };
    const auto model = read_gltf(bytes, itself);
    ASSERT_TRUE(model.ok()) << uri << model.error().line();
    EXPECT_EQ(notes_with(*model, "1 texture cannot be drawn"), 1U) << uri;
    EXPECT_EQ(model->notes.size(), 1U) << uri;
  }
}

TEST(GltfLook, PicturesOfAFileAreNotCopied) {
  const auto model = textured(png(4, 4)).read();
  ASSERT_NE(model->look, nullptr);
  const auto picture = model->look->images[0].bytes.view();
  const auto& file = *model->source->bytes;
  EXPECT_GE(picture.data(), file.data());
  EXPECT_LE(picture.data() + picture.size(), file.data() + file.size());
}

TEST(GltfLook, MaterialsOfVrm0StandBeforeThoseOfGltf) {
  auto sample = textured(png(4, 4));
  sample.json["extensions"]["VRM"]["materialProperties"] = {
      {{"name", "face"},
       {"shader", "VRM/MToon"},
       {"floatProperties", {{"_BlendMode", 1}, {"_Cutoff", 0.4}, {"_CullMode", 0}}},
       {"vectorProperties", {{"_Color", {1, 0.5, 0, 1}}, {"_MainTex", {0.25, 0.125, 0.5, 0.5}}}},
       {"textureProperties", {{"_MainTex", 0}}}}};
  const auto model = sample.read();
  ASSERT_TRUE(model.ok()) << model.error().line();
  ASSERT_NE(model->look, nullptr);
  const document::Surface& surface = model->look->surfaces[model->look->surface_of[0]];
  EXPECT_EQ(surface.alpha, AlphaMode::mask);
  EXPECT_EQ(surface.alpha_cutoff, 0.4);
  EXPECT_TRUE(surface.double_sided);
  EXPECT_NEAR(surface.base_color[1], 0.2140, 1e-3) << "as light";
  ASSERT_TRUE(surface.texture.has_value());
  // u' = 0.5 u + 0.25; in Unity's v from the foot 0.5 v + 0.125, so from the top 0.5 v + 0.375.
  EXPECT_EQ(surface.texture->offset, (std::array<double, 2>{0.25, 0.375}));
  EXPECT_EQ(surface.texture->scale, (std::array<double, 2>{0.5, 0.5}));
}

TEST(GltfLook, ToonOfVrm0ComesInTheWordsOfVrm1) {
  auto sample = textured(png(4, 4));
  sample.json["extensions"]["VRM"]["materialProperties"] = {
      {{"name", "face"},
       {"shader", "VRM/MToon"},
       {"floatProperties",
        {{"_ShadeShift", -0.2}, {"_ShadeToony", 0.8}, {"_OutlineWidthMode", 1}, {"_OutlineWidth", 0.3}}},
       {"vectorProperties", {{"_ShadeColor", {1, 0.5, 0, 1}}, {"_OutlineColor", {0, 0, 1, 1}}}},
       {"textureProperties", {{"_MainTex", 0}, {"_ShadeTexture", 0}}}}};
  const auto model = sample.read();
  ASSERT_NE(model->look, nullptr);
  const auto& toon = model->look->surfaces[model->look->surface_of[0]].toon;
  ASSERT_TRUE(toon.has_value());
  EXPECT_NEAR(toon->shade_color[1], 0.2140, 1e-3) << "as light";
  EXPECT_TRUE(toon->shade_texture.has_value());
  EXPECT_NEAR(toon->toony, 0.8 + 0.2 * 0.4, 1e-9);
  EXPECT_NEAR(toon->shift, 0.2 - 0.12, 1e-9);
  EXPECT_EQ(toon->outline, document::OutlineWidth::world);
  EXPECT_NEAR(toon->outline_width, 0.003, 1e-9) << "metres";
  EXPECT_EQ(toon->outline_color, (std::array<double, 3>{0, 0, 1}));
  EXPECT_EQ(toon->outline_mix, 0);
}

TEST(GltfLook, ToonOfVrm1StandsBeforeWhatOtherProgramsShow) {
  auto sample = textured(png(4, 4));
  auto& extensions = sample.json["materials"][0]["extensions"];
  extensions["KHR_materials_unlit"] = nlohmann::json::object();
  extensions["VRMC_materials_mtoon"] = {{"shadeColorFactor", {0.5, 0.25, 2}}, {"shadingShiftFactor", -0.05},
                                        {"shadingToonyFactor", 0.95},         {"outlineWidthMode", "screenCoordinates"},
                                        {"outlineWidthFactor", 0.004},        {"outlineColorFactor", {0.1, 0.2, 0.3}}};
  const auto model = sample.read();
  ASSERT_NE(model->look, nullptr);
  const document::Surface& surface = model->look->surfaces[model->look->surface_of[0]];
  EXPECT_FALSE(surface.unlit);
  ASSERT_TRUE(surface.toon.has_value());
  EXPECT_EQ(surface.toon->shade_color, (std::array<double, 3>{0.5, 0.25, 1})) << "colours are 0..1";
  EXPECT_EQ(surface.toon->shift, -0.05);
  EXPECT_EQ(surface.toon->toony, 0.95);
  EXPECT_EQ(surface.toon->outline, document::OutlineWidth::screen);
  EXPECT_EQ(surface.toon->outline_width, 0.004);
  EXPECT_EQ(surface.toon->outline_mix, 1);
}

TEST(GltfLook, AMirroredNodeShowsBothSides) {
  auto sample = textured(png(4, 4));
  sample.json["nodes"][0]["scale"] = {-1, 1, 1};
  const auto model = sample.read();
  ASSERT_NE(model->look, nullptr);
  EXPECT_TRUE(model->look->surfaces[model->look->surface_of[0]].double_sided);
}

TEST(SharedGltfLook, TheTexturedSquareOfTheFieldHasItsPicture) {
  const auto path = tests::shared_dir() / "cases/rigs/textures_and_uv_lost/textured.glb";
  if (!std::filesystem::exists(path)) GTEST_SKIP();
  const auto model = read_gltf(tests::read_file(path));
  ASSERT_TRUE(model.ok());
  ASSERT_NE(model->look, nullptr);
  EXPECT_EQ(model->look->images.size(), 1U);
  EXPECT_EQ(model->look->coordinates[0].size(), model->mesh->vertex_count());
  EXPECT_TRUE(model->notes.empty());
}

}  // namespace
}  // namespace penpose::io
