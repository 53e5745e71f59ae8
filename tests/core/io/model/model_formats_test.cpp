#include "core/io/model/model_formats.h"

#include <gtest/gtest.h>
#include <set>
#include <string>

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
  EXPECT_EQ(by_name("a/b.GLB"), ".glb");
  EXPECT_EQ(by_name("x.y.obj"), ".obj");
  EXPECT_EQ(by_name("x.ply"), ".ply");
  EXPECT_EQ(by_name("obj"), "");
  EXPECT_EQ(by_name("x.fbx"), "");
}

TEST(ModelFormats, ByContent) {
  EXPECT_EQ(by_content("glTF...."), ".glb");
  EXPECT_EQ(by_content("\n {\"asset\""), ".gltf");
  EXPECT_EQ(by_content("\xef\xbb\xbf{"), ".gltf");
  EXPECT_EQ(by_content("ply\r\nformat"), ".ply");
  EXPECT_EQ(by_content("OFF\n3 1 0"), ".off");
  EXPECT_EQ(by_content("# made by hand\nv 0 0 0"), ".obj");
  EXPECT_EQ(by_content("solid cube\nfacet normal"), ".stl");
  std::string binary(84 + 50, '\0');
  binary[80] = 1;
  EXPECT_EQ(by_content(binary), ".stl");
  // Its header may begin like a text.
  binary.replace(0, 2, "v ");
  EXPECT_EQ(by_content(binary), ".stl");
  binary += '\0';
  EXPECT_EQ(by_content(binary.replace(0, 2, "..")), "");
  EXPECT_EQ(by_content("hello"), "");
  EXPECT_EQ(by_content(""), "");
  EXPECT_EQ(by_content("TURNOFF"), "");
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
  EXPECT_NE(read_model(base::as_bytes("hello"), "x.fbx").error().remedy.find("PLY, STL"), std::string::npos);
  EXPECT_FALSE(read_model(base::as_bytes("hello"), "x.csv")) << "it is written alone";
  EXPECT_EQ(format_to_write("x.png").error().remedy, "name the file .glb, .obj or .csv");
  EXPECT_FALSE(format_to_write("x.ply"));
}

}  // namespace
}  // namespace penpose::io
