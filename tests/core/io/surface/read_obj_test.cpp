#include "core/io/surface/read_obj.h"

#include <gtest/gtest.h>
#include <string>

#include "tests/support/error_of.h"

namespace penpose::io {
namespace {

base::Result<document::Model> read(const std::string& text) { return read_obj(base::as_bytes(text)); }
base::Error error(const std::string& text) { return tests::error_of(read(text)); }

constexpr const char* k_square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(ReadObj, QuadsNegativeNumbersAndContinuedLines) {
  const auto model = read(std::string(k_square) + "f -4 \\\n 2/7/ 3// -1\n");
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_EQ(model->mesh->vertex_count(), 4U);
  EXPECT_EQ(model->mesh->triangle_count(), 2U);
  EXPECT_EQ(model->mesh->positions()[2], geometry::ModelPoint(1, 1, 0));
}

TEST(ReadObj, ObjectsBecomePartsWithTheVerticesOfTheFile) {
  const auto model = read(
      "o first\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no second\nv 9 9 9\nv 0 0 5\nv 1 0 5\nv 0 1 5\nf 5 6 7\no first\n"
      "v 0 0 8\nv 1 0 8\nv 0 1 8\nf -3 -2 -1\n");
  ASSERT_TRUE(model.ok()) << model.error().line();
  const auto parts = model->mesh->parts();
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_EQ(parts[0].name, "first");
  EXPECT_EQ(parts[1].name, "second");
  EXPECT_EQ(parts[1].first_vertex, 3U);  // the unused vertex stands below "o second"
  EXPECT_EQ(parts[1].vertex_count, 4U);
  EXPECT_EQ(parts[2].name, "first.2");
}

TEST(ReadObj, ObjectsThatShareVerticesBecomeOnePart) {
  const auto model = read(std::string(k_square) + "o a\nf 1 2 3\no b\nf 1 3 4\n");
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_EQ(model->mesh->parts().size(), 1U);
  EXPECT_EQ(model->notes, std::vector<std::string>{"objects that share vertices became one part"});
}

TEST(ReadObj, NormalsAreKeptWhereCornersAgree) {
  const auto model = read(std::string(k_square) + "vn 0 0 2\nvn 0 1 0\nf 1//1 2//1 3//1\nf 1//2 3//1 4//1\n");
  ASSERT_TRUE(model.ok()) << model.error().line();
  const auto normals = model->mesh->file_normals();
  ASSERT_EQ(normals.size(), 4U);
  EXPECT_EQ(normals[1], glm::vec3(0, 0, 1));
  EXPECT_EQ(normals[0], glm::vec3(0, 0, 1));  // in conflict: made from the triangles
}

TEST(ReadObj, PositionsHaveThePrecisionOfFloat) {
  // Written out, because a compiler that drops the rounding in the reader would drop it here too.
  const auto model = read("v 0.1 0.2 0.3\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_EQ(
      model->mesh->positions()[0],
      geometry::ModelPoint(0.100000001490116119384765625, 0.20000000298023223876953125, 0.300000011920928955078125));
}

TEST(ReadObj, NotesWhatIsLeftOut) {
  const auto model = read(std::string("mtllib x.mtl\nvt 0 0\nusemtl y\nl 1 2\n") + k_square + "f 1/1 2/1 3/1\n");
  ASSERT_TRUE(model.ok()) << model.error().line();
  EXPECT_EQ(model->notes.size(), 3U);
}

TEST(ReadObj, NamesTheLineOfAFault) {
  EXPECT_EQ(error("v 0 0\n").place, "line 1");
  EXPECT_EQ(error("v 0 0 nan\n").place, "line 1");
  EXPECT_EQ(error(std::string(k_square) + "f 1 2 5\n").place, "line 5");
  EXPECT_EQ(error(std::string(k_square) + "f 1 2 0\n").place, "line 5");
  EXPECT_EQ(error(std::string(k_square) + "f 1 2 -5\n").place, "line 5");
  EXPECT_EQ(error(std::string(k_square) + "f 1 2 99999999999999999999\n").place, "line 5");
  EXPECT_EQ(error(std::string(k_square) + "f 1 2\n").place, "line 5");
  EXPECT_EQ(error(std::string(k_square) + "f 1//1 2//1 3//1\n").place, "line 5");
  EXPECT_NE(error(k_square).what.find("no faces"), std::string::npos);
  EXPECT_NE(error("# nothing\n").what.find("no vertices"), std::string::npos);
}

TEST(ReadObj, AThirdTriangleAtAnEdgeIsASheetOfItsOwn) {
  const auto model = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 0 -1\nf 1 2 3\nf 1 2 4\nf 1 2 5\n");
  ASSERT_TRUE(model.ok());
  EXPECT_EQ(model->mesh->triangle_count(), 3U);
  EXPECT_EQ(model->notes.size(), 1U);
}

TEST(ReadObj, NamesThatAreNoTextAreMadeText) {
  const auto model = read(std::string("o \xe9ye\n") + k_square + "f 1 2 3\n");
  ASSERT_TRUE(model.ok());
  EXPECT_EQ(model->mesh->parts()[0].name, "?ye");
}

}  // namespace
}  // namespace penpose::io
