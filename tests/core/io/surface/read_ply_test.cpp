#include "core/io/surface/read_ply.h"

#include <algorithm>
#include <bit>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "core/document/model.h"
#include "tests/support/error_of.h"

namespace penpose::io {
namespace {

base::Result<document::Model> read(const std::string& text) { return read_ply(base::as_bytes(text)); }
base::Error error(const std::string& text) { return tests::error_of(read(text)); }

std::string header(const std::string& format, const std::string& vertices = "4", const std::string& faces = "1") {
  return "ply\nformat " + format + " 1.0\ncomment made by a test\nelement vertex " + vertices +
         "\nproperty float x\nproperty double y\nproperty uchar red\nproperty short z\nelement extra 1\nproperty list "
         "uchar int "
         "junk\nelement face " +
         faces + "\nproperty list uchar uint vertex_indices\nend_header\n";
}

/// The square that `header` announces, in binary.
std::string binary_square(bool big) {
  std::string text = header(big ? "binary_big_endian" : "binary_little_endian");
  const auto add = [&](auto value) {
    std::string raw(reinterpret_cast<const char*>(&value), sizeof value);
    if (big == (std::endian::native == std::endian::little)) std::reverse(raw.begin(), raw.end());
    text += raw;
  };
  const float xs[] = {0, 1, 1, 0};
  const double ys[] = {0, 0, 1, 1};
  for (int v = 0; v < 4; ++v) {
    add(xs[v]);
    add(ys[v]);
    add(std::uint8_t{255});
    add(std::int16_t{-3});
  }
  add(std::uint8_t{2});
  add(std::int32_t{7});
  add(std::int32_t{-7});
  add(std::uint8_t{4});
  for (std::uint32_t v = 0; v < 4; ++v) add(v);
  return text;
}

const char* const k_body = "0 0 255 -3\n1 0 255 -3\n1 1 255 -3\n0 1 255 -3\n2 7 -7\n4 0 1 2 3\n";

TEST(ReadPly, AllThreeEncodingsGiveTheSameModel) {
  const auto text = read(header("ascii") + k_body);
  ASSERT_TRUE(text.ok()) << text.error().line();
  EXPECT_EQ(text->mesh->triangle_count(), 2U);
  EXPECT_EQ(text->mesh->positions()[2], geometry::ModelPoint(1, 1, -3));
  EXPECT_EQ(text->notes, std::vector<std::string>{"vertex colours were left out"});
  for (const bool big : {false, true}) {
    const auto binary = read(binary_square(big));
    ASSERT_TRUE(binary.ok()) << binary.error().line();
    EXPECT_EQ(document::state_hash(*binary), document::state_hash(*text));
  }
}

TEST(ReadPly, NormalsAndFacesBeforeVertices) {
  const auto model = read(
      "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_index\nelement vertex 3\nproperty float "
      "x\n"
      "property float y\nproperty float z\nproperty float nx\nproperty float ny\nproperty float nz\nend_header\n3 0 1 "
      "2\n"
      "0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n");
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_EQ(model->mesh->file_normals()[1], glm::vec3(0, 0, 1));
}

TEST(ReadPly, SplatsAreCalledWhatTheyAre) {
  for (const std::string name : {"packed_position", "f_dc_0"}) {
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
        "property float " +
        name + "\nend_header\n0 0 0 0\n";
    const auto model = read(text);
    ASSERT_FALSE(model.ok());
    EXPECT_NE(model.error().what.find("splats"), std::string::npos) << model.error().line();
  }
}

TEST(ReadPly, NamesThePlaceOfAFault) {
  EXPECT_EQ(error("plyx\n").place, "line 1");
  EXPECT_EQ(error("ply\nformat ascii 1.0\n").place, "line 2");
  EXPECT_EQ(error("ply\nformat odd 1.0\nend_header\n").place, "line 2");
  EXPECT_EQ(error("ply\nend_header\n").place, "line 2");
  EXPECT_EQ(error("ply\nformat ascii 1.0\nproperty float x\n").place, "line 3");
  EXPECT_EQ(error("ply\nformat ascii 1.0\nelement vertex many\n").place, "line 3");
  EXPECT_EQ(error("ply\nformat ascii 1.0\nelement vertex 1\nproperty list float int x\n").place, "line 4");
  EXPECT_EQ(error("ply\nformat ascii 1.0\nelement vertex 18446744073709551615\nend_header\n").place, "line 4");
  EXPECT_EQ(error(header("ascii", "4000000000") + k_body).place, "line 13");
  EXPECT_EQ(error(header("ascii") + "0 0 255 -3\n1 nan 255 -3\n").place, "line 15");
  EXPECT_EQ(error(header("ascii") + "0 0 255 -3\n1 x 255 -3\n").place, "line 15");
  std::string body = k_body;
  body.replace(body.size() - 2, 1, "4");
  EXPECT_EQ(error(header("ascii") + body).place, "face 0");
  const std::string binary = binary_square(false);
  for (std::size_t size = 0; size < binary.size(); ++size) {
    EXPECT_FALSE(read(binary.substr(0, size)).ok()) << size;
  }
  EXPECT_NE(error(binary.substr(0, binary.size() - 1)).place.find("byte offset"), std::string::npos);
  EXPECT_EQ(error(header("binary_little_endian", "4294967295") + std::string(60, '\0')).place,
            "byte offset " + std::to_string(header("binary_little_endian", "4294967295").size()));
}

}  // namespace
}  // namespace penpose::io
