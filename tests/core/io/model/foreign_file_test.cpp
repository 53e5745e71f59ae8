#include "core/io/model/foreign_file.h"

#include <gtest/gtest.h>

#include "core/io/model/read_model.h"
#include "core/io/project/read_document.h"
#include "tests/support/models/gltf_sample.h"

namespace penpose::io {
namespace {

using namespace std::string_view_literals;

TEST(ForeignFile, IsCalledWhatItIs) {
  struct Case {
    std::string_view bytes;
    const char* word;
  };
  const Case cases[] = {
      {"<!DOCTYPE html><html><head><title>GitHub</title>", "web page"},
      {"\xef\xbb\xbf\n <HTML lang=en>", "web page"},
      {"<?xml version=\"1.0\"?><!DOCTYPE html PUBLIC \"-//W3C//DTD XHTML 1.0\">", "web page"},
      {"version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 12\n", "Git LFS pointer"},
      {"PK\x03\x04 and so on", "zip archive"},
      {"PK\x03\x04\x14\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x09\0\0\0head.usdc"sv, "USDZ"},
      {"7z\xbc\xaf\x27\x1c..", "7z archive"},
      {"\x1f\x8b\x08..", "gzip"},
      {"BLENDER-v304", ".blend"},
      {"\x28\xb5\x2f\xfd..", ".blend"},
      {"#usda 1.0\n", "USD"},
      {"PXR-USDC..", "USD"},
      {"<?xml version=\"1.0\"?>\n<COLLADA xmlns=\"x\">", "COLLADA"},
      {"<?xml version=\"1.0\"?>\n<Error><Code>AccessDenied</Code></Error>", "error message of a server"},
      {"\x89PNG\r\n\x1a\n....", "picture"},
      {"HIERARCHY\r\nROOT Hips\r\n{\r\n", "BVH"},
      {"DRACO\2\2\1\1", "Draco"},
      {"\xabKTX 20\xbb\r\n\x1a\n", "texture"},
  };
  for (const Case& one : cases) {
    for (const char* name : {"face.glb", "face.obj", "face.ply", "face.vrm", "face"}) {
      const auto model = read_model(base::as_bytes(one.bytes), name);
      ASSERT_FALSE(model.ok()) << one.word;
      EXPECT_NE(model.error().what.find(one.word), std::string::npos) << model.error().line();
      EXPECT_EQ(model.error().place, "byte offset 0");
      EXPECT_FALSE(model.error().remedy.empty());
      const auto document = read_document(base::as_bytes(one.bytes), name);
      ASSERT_FALSE(document.ok());
      EXPECT_EQ(document.error().what, model.error().what);
    }
  }
}

TEST(ForeignFile, ModelsAreNot) {
  EXPECT_FALSE(foreign_file(tests::square_sample().glb()));
  EXPECT_FALSE(foreign_file(base::as_bytes("v 0 0 0\n")));
  EXPECT_FALSE(foreign_file(base::as_bytes("s 1\nv 0 0 0\n")));
  // A binary STL begins with 80 bytes of anything.
  std::vector<std::uint8_t> stl(84 + 50, 0);
  stl[80] = 1;
  EXPECT_FALSE(foreign_file(stl));
}

TEST(ForeignFile, JsonOfAServerIsNoDamagedGltf) {
  const auto model = read_model(base::as_bytes("{\"message\": \"Not Found\"}"), "face.gltf");
  ASSERT_FALSE(model.ok());
  EXPECT_NE(model.error().what.find("no glTF"), std::string::npos) << model.error().line();
}

TEST(ForeignFile, ACutDownloadIsCalledThat) {
  auto bytes = tests::square_sample().glb();
  bytes.resize(bytes.size() - 20);
  const auto model = read_model(bytes, "face.glb");
  ASSERT_FALSE(model.ok());
  EXPECT_NE(model.error().what.find("not finished"), std::string::npos) << model.error().line();
}

}  // namespace
}  // namespace penpose::io
