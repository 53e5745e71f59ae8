#include "core/io/model/model_formats.h"

#include <gtest/gtest.h>
#include <map>
#include <set>
#include <string>

#include "tests/support/models/figure_sample.h"

namespace penpose::io {
namespace {

std::string_view by_name(std::string_view file_name) {
  const ModelFormat* format = format_of_name(file_name);
  return format == nullptr ? "" : format->extension;
}
std::string_view by_content(const std::string& text) {
  const ModelFormat* format = format_of_content(base::as_bytes(text));
  return format == nullptr ? "" : format->extension;
}

TEST(ModelFormats, ByName) {
  for (const auto& [name, extension] : std::map<std::string, std::string>{
           {"a/b.GLB", ".glb"}, {"x.y.obj", ".obj"}, {"x.ply", ".ply"}, {"obj", ""}, {"x.fbx", ".fbx"}, {"x.dae", ""}})
    EXPECT_EQ(by_name(name), extension) << name;
}

TEST(ModelFormats, ByContent) {
  for (const auto& [text, extension] : std::map<std::string, std::string>{{"glTF....", ".glb"},
                                                                          {"\n {\"asset\"", ".gltf"},
                                                                          {"\xef\xbb\xbf{", ".gltf"},
                                                                          {"ply\r\nformat", ".ply"},
                                                                          {"OFF\n3 1 0", ".off"},
                                                                          {"# made by hand\nv 0 0 0", ".obj"},
                                                                          {"solid cube\nfacet normal", ".stl"},
                                                                          {"hello", ""},
                                                                          {"", ""},
                                                                          {"TURNOFF", ""}})
    EXPECT_EQ(by_content(text), extension) << text;
}

TEST(ModelFormats, BinaryStlByItsLength) {
  std::string binary(84 + 50, '\0');
  binary[80] = 1;
  EXPECT_EQ(by_content(binary), ".stl");
  // Its header may begin like a text.
  binary.replace(0, 2, "v ");
  EXPECT_EQ(by_content(binary), ".stl");
  binary += '\0';
  EXPECT_EQ(by_content(binary.replace(0, 2, "..")), "");
}

TEST(ModelFormats, EachIsReadOrWrittenAndHasAnExtensionOfItsOwn) {
  std::set<std::string_view> extensions;
  for (const ModelFormat& format : model_formats()) {
    EXPECT_TRUE(extensions.insert(format.extension).second) << format.extension;
    EXPECT_TRUE(format.extension.starts_with('.')) << format.extension;
    EXPECT_TRUE(format.read != nullptr || format.write != nullptr) << format.extension;
    EXPECT_EQ(format.write != nullptr, !format.holds.empty()) << format.extension << " is offered where it is written";
    EXPECT_TRUE(format.write != nullptr || format.write_project == nullptr) << format.extension;
  }
}

TEST(ModelFormats, WhatIsNotKnownIsToldWithWhatIs) {
  EXPECT_NE(read_model(base::as_bytes("hello"), "x.dae").error().remedy.find("PLY, STL"), std::string::npos);
  EXPECT_FALSE(read_model(base::as_bytes("hello"), "x.csv")) << "it is written alone";
  EXPECT_EQ(format_to_write("x.png").error().remedy,
            "name the file .glb, .fbx, .gltf, .obj, .vrm, .csv, .vrma or .vmd");
  EXPECT_FALSE(format_to_write("x.ply"));
}

TEST(ModelFormats, AnAvatarIsWrittenAsOneAndNothingElseIs) {
  const auto avatar = tests::avatar_sample(tests::upright_bones()).read().value();
  const auto written = write_model(avatar, "x.vrm");
  ASSERT_TRUE(written) << written.error().line();
  EXPECT_EQ(read_model(*written, "x.vrm").value().expressions.size(), 1U);
  EXPECT_EQ(write_model(avatar, "x.vrm", {.bare = true}).error().remedy, "name the file .glb");
  EXPECT_EQ(write_model(tests::morph_sample().read().value(), "x.vrm").error().what,
            "the model is no VRM avatar, or cannot be kept as one");
}

TEST(ModelFormats, FilesThatKeepEverythingAreToldByName) {
  EXPECT_TRUE(keeps_everything("a.GLB"));
  EXPECT_TRUE(keeps_everything("a.vrm"));
  EXPECT_FALSE(keeps_everything("a.obj"));
  EXPECT_FALSE(keeps_everything("glb"));
  EXPECT_EQ(extensions_that_keep_everything(), ".glb, .gltf or .vrm");
}

}  // namespace
}  // namespace penpose::io
