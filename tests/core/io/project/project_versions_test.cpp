#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>

#include "core/io/project/read_document.h"
#include "core/io/project/write_document.h"

namespace penpose::io {
namespace {

/// The version that this program writes.
constexpr int k_newest = 2;

std::vector<std::uint8_t> project_of_version(int version) {
  const auto path =
      std::filesystem::path(PENPOSE_TEST_DATA) / "projects" / ("version" + std::to_string(version) + ".glb");
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// The same bytes with the digit after the extras' "version": replaced, so that the file keeps its lengths.
std::vector<std::uint8_t> with_version(std::vector<std::uint8_t> bytes, char digit) {
  const std::string text(bytes.begin(), bytes.end());
  const std::size_t extras = text.find("\"penpose\":{");
  const std::size_t key = text.find("\"version\":", extras);
  EXPECT_NE(key, std::string::npos);
  bytes[key + 10] = static_cast<std::uint8_t>(digit);
  return bytes;
}

// A file of every version that was ever written is kept; the one of a new version is added with it.
TEST(ProjectVersions, AFileOfEveryVersionLoads) {
  for (int version = 1; version <= k_newest; ++version) {
    const auto bytes = project_of_version(version);
    ASSERT_FALSE(bytes.empty()) << "no file of version " << version;
    const auto document = read_document(bytes, "project.glb");
    ASSERT_TRUE(document) << document.error().line();
    ASSERT_NE(document->model->deformers, nullptr) << version;
    EXPECT_EQ(document->model->deformers->parameters()[0].name, "bump");
  }
  const auto newest = write_project(read_document(project_of_version(k_newest), "project.glb").value());
  ASSERT_TRUE(newest);
  const std::string text(newest->begin(), newest->end());
  const std::string version = "\"version\":" + std::to_string(k_newest);
  EXPECT_NE(text.find(version), std::string::npos) << "keep a file of the new version, and raise k_newest";
}

TEST(ProjectVersions, TheSecondKeepsWhatWasDrawn) {
  const auto document = read_document(project_of_version(2), "project.glb");
  ASSERT_TRUE(document);
  ASSERT_EQ(document->curves.size(), 3U);
  EXPECT_TRUE(document->curves[0]->target);
  EXPECT_EQ(document->curves[1]->kept.size(), document::k_pose_curve_points);
  EXPECT_EQ(document->curves[2]->points.size(), 1U) << "a pin";
  EXPECT_EQ(document->locked, std::vector<std::string>{"bump"});
  ASSERT_EQ(document->timeline->keys.size(), 1U);
  EXPECT_EQ(document->timeline->keys[0].name, "raised");
  ASSERT_EQ(document->views.size(), 1U);
  ASSERT_NE(document->pending, nullptr);
  EXPECT_EQ(document->pending->sketch.name, "dent");
  EXPECT_EQ(document->pending->sketch.general.size(), 4U);
  EXPECT_NEAR(document->pose[0], 0.5568, 1e-3);
}

TEST(ProjectVersions, ALaterOneIsRefusedByName) {
  const auto document = read_document(with_version(project_of_version(2), '9'), "project.glb");
  ASSERT_FALSE(document);
  EXPECT_EQ(document.error().what, "the version of the extras, 9, is not known");
  EXPECT_EQ(document.error().place, "/extras/penpose/version");
}

}  // namespace
}  // namespace penpose::io
