#include "ui/app/browser/file_list.h"

#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

namespace penpose::app {
namespace {

namespace fs = std::filesystem;

/// A folder of this test alone.
class FileList : public testing::Test {
 protected:
  FileList() {
    fs::create_directories(folder / "Documents");
    fs::create_directories(folder / "drafts");
    fs::create_directories(folder / ".cache");
    write("head2.glb", 30);
    write("head10.glb", 10);
    write("Arm.OBJ", 2000);
    write("notes.txt", 5);
    write(".hidden.glb", 1);
    fs::last_write_time(folder / "head10.glb", fs::file_time_type::clock::now() + std::chrono::hours(1));
  }
  ~FileList() override { fs::remove_all(folder); }
  void write(const char* name, std::size_t bytes) const { std::ofstream(folder / name) << std::string(bytes, 'x'); }
  [[nodiscard]] std::vector<std::string> names(const FileView& view) const {
    std::vector<std::string> out;
    const auto found = list_folder(folder.string(), view);
    EXPECT_TRUE(found.ok());
    if (found) {
      for (const FileEntry& one : *found) out.push_back(one.name);
    }
    return out;
  }
  using Names = std::vector<std::string>;
  fs::path folder = fs::temp_directory_path() / ("penpose-file-list-" + std::to_string(::getpid()));
};

TEST_F(FileList, FoldersComeFirstAndNumbersCountAsNumbers) {
  EXPECT_EQ(names({FileSort::name, false, {".glb", ".obj"}, {}}),
            (Names{"Documents", "drafts", "Arm.OBJ", "head2.glb", "head10.glb"}));
  EXPECT_EQ(names({}).size(), 6U) << "every file, but the hidden ones";
  EXPECT_EQ(names({FileSort::name, true, {".glb"}, {}}),
            (Names{".cache", "Documents", "drafts", ".hidden.glb", "head2.glb", "head10.glb"}));
}

TEST_F(FileList, TheNewestOrTheLargestIsFirst) {
  EXPECT_EQ(names({FileSort::date, false, {".glb"}, "h"}), (Names{"head10.glb", "head2.glb"}));
  EXPECT_EQ(names({FileSort::size, false, {}, {}})[2], "Arm.OBJ");
}

TEST_F(FileList, WhatIsTypedNarrowsItInEitherCase) {
  EXPECT_EQ(names({FileSort::name, false, {}, "HEAD1"}), (Names{"head10.glb"}));
  EXPECT_EQ(names({FileSort::name, false, {}, "d"}), (Names{"Documents", "drafts"}));
  EXPECT_EQ(names({FileSort::name, false, {}, "."}), (Names{".cache", ".hidden.glb"})) << "whoever types the dot";
}

TEST_F(FileList, WhatIsNoFolderIsSaid) {
  EXPECT_FALSE(list_folder((folder / "none").string(), {}).ok());
  EXPECT_FALSE(list_folder((folder / "notes.txt").string(), {}).ok());
}

TEST_F(FileList, APathIsTypedFromHereFromTheRootAndFromHome) {
  const std::string here = folder.string();
  EXPECT_EQ(typed_path(here, "head", "/home/u").folder, here);
  EXPECT_EQ(typed_path(here, "drafts/he", "/home/u").folder, here + "/drafts");
  EXPECT_EQ(typed_path(here, "drafts/he", "/home/u").name, "he");
  EXPECT_EQ(typed_path(here, "../", "/home/u").folder, folder.parent_path().string());
  EXPECT_EQ(typed_path(here, "/", "/home/u").folder, "/");
  EXPECT_EQ(typed_path(here, "/usr/share/x", "/home/u").folder, "/usr/share");
  EXPECT_EQ(typed_path(here, "~/face.glb", "/home/u").folder, "/home/u");
  EXPECT_EQ(typed_path(here, "~", "/home/u").folder, "/home/u");
}

TEST_F(FileList, TabGoesAsFarAsThereIsNoChoice) {
  const std::string here = folder.string();
  EXPECT_EQ(completed_path(here, "do", "", {}), "Documents/");
  EXPECT_EQ(completed_path(here, "he", "", {}), "head");
  EXPECT_EQ(completed_path(here, "head1", "", {}), "head10.glb");
  EXPECT_EQ(completed_path(here, "drafts/../A", "", {}), "drafts/../Arm.OBJ");
  EXPECT_EQ(completed_path(here, "zz", "", {}), "zz");
  EXPECT_EQ(completed_path(here, "~/do", here, {}), "~/Documents/");
}

TEST_F(FileList, AFolderIsMadeOnceAndUnderANameThatIsOne) {
  const auto made = make_folder(folder.string(), "new one");
  ASSERT_TRUE(made.ok());
  EXPECT_TRUE(fs::is_directory(*made));
  for (const char* name : {"new one", "", "a/b", "..", "notes.txt"}) {
    const auto again = make_folder(folder.string(), name);
    ASSERT_FALSE(again.ok()) << name;
    EXPECT_TRUE(again.error().what.starts_with('"')) << "it says which: " << again.error().what;
    EXPECT_NE(again.error().what.find(name), std::string::npos);
  }
  EXPECT_FALSE(make_folder((folder / "none").string(), "x").ok());
}

TEST(FileTexts, SizesAreShort) {
  EXPECT_EQ(size_text(0), "0 B");
  EXPECT_EQ(size_text(999), "999 B");
  EXPECT_EQ(size_text(1000), "1.0 KB");
  EXPECT_EQ(size_text(12'345), "12 KB");
  EXPECT_EQ(size_text(3'400'000), "3.4 MB");
  EXPECT_EQ(size_text(999'700), "1.0 MB");
}

}  // namespace
}  // namespace penpose::app
