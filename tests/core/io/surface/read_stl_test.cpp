#include "core/io/surface/read_stl.h"

#include <bit>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

#include "core/base/byte_writer.h"

namespace penpose::io {
namespace {

std::vector<std::uint8_t> binary(std::uint32_t count, const std::vector<float>& corners, const char* start = "") {
  base::ByteWriter file;
  file.append(start);
  while (file.size() < 80) file.write(std::uint8_t{0});
  file.write(count);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (i % 9 == 0) {
      for (int n = 0; n < 3; ++n) file.write_f32(0);
    }
    file.write_f32(corners[i]);
    if (i % 9 == 8) file.write(std::uint16_t{0});
  }
  return file.take();
}

const std::vector<float> k_square = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, -0.0F, 0, 1, 1, 0, 0, 1, 0};

TEST(ReadStl, BinaryCornersAtOnePlaceBecomeOneVertex) {
  for (const char* start : {"", "solid of binary kind"}) {
    const auto model = read_stl(binary(2, k_square, start));
    ASSERT_TRUE(model.ok()) << model.error().line();
    EXPECT_EQ(model->mesh->vertex_count(), 4U);
    EXPECT_EQ(model->mesh->triangle_count(), 2U);
    EXPECT_EQ(model->mesh->positions()[3], geometry::ModelPoint(0, 1, 0));
  }
}

TEST(ReadStl, TextSolidsBecomeParts) {
  const std::string facet =
      "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n endloop\nendfacet\n";
  const std::string text = "solid a b\n" + facet + "endsolid a b\nsolid\nendsolid\nsolid c\n" + facet + "endsolid\n";
  const auto model = read_stl(base::as_bytes(text));
  ASSERT_TRUE(model.ok()) << model.error().line();
  ASSERT_EQ(model->mesh->parts().size(), 2U);
  EXPECT_EQ(model->mesh->parts()[0].name, "a b");
  EXPECT_EQ(model->mesh->parts()[1].first_vertex, 3U);
}

TEST(ReadStl, NamesThePlaceOfAFault) {
  const auto place = [](base::Bytes bytes) {
    const auto model = read_stl(bytes);
    return model ? "(no error)" : model.error().place;
  };
  EXPECT_EQ(place(base::as_bytes("short")), "byte offset 5");
  EXPECT_EQ(place(binary(0xffffffffU, k_square)), "byte offset 80");
  EXPECT_EQ(place(binary(3, k_square)), "byte offset 80");
  auto nan = k_square;
  nan[10] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(place(binary(2, nan)), "byte offset 134");
  EXPECT_EQ(place(base::as_bytes("solid\nfacet\nvertex 0 0 0\nvertex 0 x 0\n")), "line 4");
  EXPECT_EQ(place(base::as_bytes("solid\nfacet\nvertex 0 0 0\nendfacet\n")), "line 4");
  EXPECT_EQ(place(base::as_bytes("solid\nfacet\nvertex 0 0 0\nvertex 0 0 0\nvertex 0 0 0\nvertex 0 0 0\n")), "line 6");
  EXPECT_EQ(place(base::as_bytes("solid\nfacet\nvertex 0 0 0\n")), "line 3");
}

}  // namespace
}  // namespace penpose::io
