#include "core/io/model/formats.h"

#include <gtest/gtest.h>
#include <string>

namespace penpose::io {
namespace {

std::optional<Format> content(const std::string& text) { return format_of_content(base::as_bytes(text)); }

TEST(Formats, ByName) {
  EXPECT_EQ(format_of_name("a/b.GLB"), Format::glb);
  EXPECT_EQ(format_of_name("x.y.obj"), Format::obj);
  EXPECT_EQ(format_of_name("x.ply"), Format::ply);
  EXPECT_FALSE(format_of_name("obj"));
  EXPECT_FALSE(format_of_name("x.fbx"));
}

TEST(Formats, ByContent) {
  EXPECT_EQ(content("glTF...."), Format::glb);
  EXPECT_EQ(content("\n {\"asset\""), Format::gltf);
  EXPECT_EQ(content("\xef\xbb\xbf{"), Format::gltf);
  EXPECT_EQ(content("ply\r\nformat"), Format::ply);
  EXPECT_EQ(content("OFF\n3 1 0"), Format::off);
  EXPECT_EQ(content("# made by hand\nv 0 0 0"), Format::obj);
  EXPECT_EQ(content("solid cube\nfacet normal"), Format::stl);
  std::string binary(84 + 50, '\0');
  binary[80] = 1;
  EXPECT_EQ(content(binary), Format::stl);
  binary += '\0';
  EXPECT_FALSE(content(binary));
  EXPECT_FALSE(content("hello"));
  EXPECT_FALSE(content(""));
  EXPECT_FALSE(content("TURNOFF"));
}

}  // namespace
}  // namespace penpose::io
