#include "core/io/gltf/read/internal/gltf_document.h"

#include <gtest/gtest.h>

#include "tests/support/models/gltf_sample.h"

namespace penpose::io {
namespace {

std::string place(base::Bytes bytes) {
  const auto document = open_gltf(bytes, {});
  return document ? "(no error)" : document.error().place;
}

std::string text_with_uri(const std::string& uri) {
  tests::GltfSample sample = tests::square_sample();
  sample.set_buffer();
  sample.json["buffers"][0]["uri"] = uri;
  return sample.json.dump();
}

std::string base64(const std::vector<std::uint8_t>& bytes) {
  constexpr std::string_view k_digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) bits = (bits << 8) | (i + k < bytes.size() ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : k_digits[(bits >> (18 - 6 * k)) & 63];
  }
  return text;
}

// 20,000 buffers of one file were 20,000 copies of it.
TEST(GltfDocument, AFileIsReadOnceByWhateverNameItGoes) {
  tests::GltfSample sample = tests::square_sample();
  sample.set_buffer();
  const auto first = sample.json["buffers"][0];
  sample.json["buffers"] = nlohmann::json::array();
  const char* const names[] = {"data.bin", "./data.bin", "././data.bin", ".//data%2Ebin", "data.bin"};
  for (int i = 0; i < 5000; ++i) {
    sample.json["buffers"].push_back(first);
    sample.json["buffers"].back()["uri"] = names[i % 5];
  }
  int reads = 0;
  const FileResolver resolve = [&](const std::string& path) -> base::Result<std::vector<std::uint8_t>> {
    ++reads;
    EXPECT_EQ(path, "data.bin");
    return sample.binary;
  };
  const std::string text = sample.json.dump();
  const auto document = open_gltf(base::as_bytes(text), resolve);
  ASSERT_TRUE(document) << document.error().line();
  EXPECT_EQ(reads, 1);
  EXPECT_EQ(document->buffers.size(), 5000U);
  EXPECT_EQ(document->owned.size(), 1U);
  EXPECT_EQ(document->buffers.front().data(), document->buffers.back().data());
}

TEST(GltfDocument, NoMoreFilesAreOpenedThanAModelHas) {
  tests::GltfSample sample = tests::square_sample();
  sample.set_buffer();
  const auto first = sample.json["buffers"][0];
  for (int i = 0; i < 10000; ++i) {
    sample.json["buffers"].push_back(first);
    sample.json["buffers"].back()["uri"] = std::to_string(i) + ".bin";
  }
  sample.json["buffers"][0]["uri"] = "data.bin";
  int reads = 0;
  const FileResolver resolve = [&](const std::string&) -> base::Result<std::vector<std::uint8_t>> {
    ++reads;
    return sample.binary;
  };
  const std::string text = sample.json.dump();
  EXPECT_FALSE(open_gltf(base::as_bytes(text), resolve));
  EXPECT_LT(reads, 5000);
}

TEST(GltfDocument, EveryTruncationOfAContainerIsRefused) {
  const auto bytes = tests::square_sample().glb();
  ASSERT_EQ(place(bytes), "(no error)");
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_NE(place(base::Bytes(bytes).first(size)), "(no error)") << size;
  }
}

TEST(GltfDocument, ContainerFaultsAreNamedByTheirByte) {
  auto bytes = tests::square_sample().glb();
  auto bent = [&](std::size_t at, std::uint8_t value) {
    auto copy = bytes;
    copy[at] = value;
    return place(copy);
  };
  EXPECT_EQ(bent(4, 1), "byte offset 4");
  EXPECT_EQ(bent(11, 0x7f), "byte offset 8");
  EXPECT_EQ(bent(15, 0xff), "byte offset 12");
  EXPECT_EQ(bent(16, 'X'), "byte offset 12");
  EXPECT_EQ(bent(21, 'X'), "byte offset 1 of the JSON chunk");
}

TEST(GltfDocument, DataUris) {
  tests::GltfSample sample = tests::square_sample();
  const std::string uri = "data:application/octet-stream;base64," + base64(sample.binary);
  const auto document = open_gltf(base::as_bytes(text_with_uri(uri)), {});
  ASSERT_TRUE(document.ok()) << document.error().line();
  EXPECT_TRUE(std::equal(sample.binary.begin(), sample.binary.end(), document->buffers[0].begin()));
  std::string escaped = "data:application/octet-stream,";
  for (const std::uint8_t byte : sample.binary) {
    constexpr std::string_view k_digits = "0123456789abcdef";
    escaped += {'%', k_digits[byte >> 4], k_digits[byte & 15]};
  }
  EXPECT_EQ(place(base::as_bytes(text_with_uri(escaped))), "(no error)");
  EXPECT_EQ(place(base::as_bytes(text_with_uri("data:text/plain,abc"))), "/buffers/0/byteLength");
  EXPECT_EQ(place(base::as_bytes(text_with_uri("data:;base64,@@@@"))), "/buffers/0/uri");
  EXPECT_EQ(place(base::as_bytes(text_with_uri("data:;base64,AAAA"))), "/buffers/0/byteLength");
}

TEST(GltfDocument, FilesBesideTheModelComeThroughTheResolver) {
  const tests::GltfSample sample = tests::square_sample();
  std::string asked;
  const FileResolver resolve = [&](const std::string& path) -> base::Result<std::vector<std::uint8_t>> {
    asked = path;
    return sample.binary;
  };
  ASSERT_TRUE(open_gltf(base::as_bytes(text_with_uri("sub/my%20data.bin")), resolve).ok());
  EXPECT_EQ(asked, "sub/my data.bin");
  for (const char* uri :
       {"../x.bin", "a/../../x.bin", "/etc/passwd", "http://host/x.bin", "file:x", "%2e%2e/x", "", "a\\..\\..\\b"}) {
    asked.clear();
    EXPECT_FALSE(open_gltf(base::as_bytes(text_with_uri(uri)), resolve).ok()) << uri;
    EXPECT_EQ(asked, "");
  }
  EXPECT_EQ(place(base::as_bytes(text_with_uri("x.bin"))), "/buffers/0/uri");
  ASSERT_TRUE(open_gltf(base::as_bytes(text_with_uri("bufs\\b.bin")), resolve).ok());
  EXPECT_EQ(asked, "bufs/b.bin");
}

TEST(GltfDocument, ANameThatWasNotEscapedIsFound) {
  const tests::GltfSample sample = tests::square_sample();
  const FileResolver resolve = [&](const std::string& path) -> base::Result<std::vector<std::uint8_t>> {
    if (path != "100%41.bin") return base::Error{"cannot be opened", "", ""};
    return sample.binary;
  };
  EXPECT_TRUE(open_gltf(base::as_bytes(text_with_uri("100%41.bin")), resolve).ok());
  EXPECT_FALSE(open_gltf(base::as_bytes(text_with_uri("200%41.bin")), resolve).ok());
}

TEST(GltfDocument, BuffersAreChecked) {
  tests::GltfSample sample = tests::square_sample();
  sample.set_buffer();
  const auto bent = [&](const nlohmann::json& buffers) {
    nlohmann::json copy = sample.json;
    copy["buffers"] = buffers;
    return place(tests::GltfSample::glb_of(copy.dump(), sample.binary));
  };
  EXPECT_EQ(bent({{{"byteLength", 1 << 20}}}), "/buffers/0/byteLength");
  EXPECT_EQ(bent({{{"byteLength", -1}}}), "/buffers/0");
  EXPECT_EQ(bent({3}), "/buffers/0");
  EXPECT_EQ(bent({{{"byteLength", 4}, {"uri", 5}}}), "/buffers/0");
  EXPECT_EQ(bent({{{"byteLength", 4}}, {{"byteLength", 4}}}), "/buffers/1");
}

}  // namespace
}  // namespace penpose::io
