#include "core/io/gltf/read/uri/uri.h"

#include <gtest/gtest.h>

namespace penpose::io {
namespace {

std::string text(const base::Result<std::vector<std::uint8_t>>& bytes) {
  return bytes ? std::string(bytes->begin(), bytes->end()) : bytes.error().what;
}

TEST(Uri, DataMayBeBase64OrCharacters) {
  EXPECT_EQ(text(decode_data_uri("data:application/octet-stream;base64,YWJj")), "abc");
  EXPECT_EQ(text(decode_data_uri("data:;base64,YWI%3D")), "ab") << "escaped once more";
  EXPECT_EQ(text(decode_data_uri("data:;BASE64,YW\nJj")), "abc");
  EXPECT_EQ(text(decode_data_uri("data:text/plain,a%20b%2Cc")), "a b,c");
  EXPECT_EQ(text(decode_data_uri("data:,")), "");
  EXPECT_FALSE(decode_data_uri("data:no comma").ok());
  EXPECT_FALSE(decode_data_uri("data:;base64,@@").ok());
}

TEST(Uri, PathsOfWindowsArePathsBelowTheModel) {
  EXPECT_EQ(path_of_uri("bufs\\b.bin"), "bufs/b.bin");
  EXPECT_EQ(path_of_uri("bufs%5Cb%20c.bin"), "bufs/b c.bin");
  EXPECT_EQ(path_of_uri(".\\\\b.bin"), "b.bin");
  EXPECT_EQ(path_as_written("100%25.bin"), "100%25.bin");
  for (const char* uri : {"", "..\\x", "a\\..\\..\\x", "\\x", "\\\\host\\x", "C:\\x", "a/%2e%2e/x", ".", "a%00b"}) {
    EXPECT_FALSE(path_of_uri(uri)) << uri;
    if (std::string_view(uri).find('%') == std::string_view::npos) {
      EXPECT_FALSE(path_as_written(uri)) << uri;
    }
  }
}

}  // namespace
}  // namespace penpose::io
