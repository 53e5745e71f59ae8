#include "ui/files/files.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

#include "ui/cli/commands.h"

namespace penpose::files {
namespace {

class Files : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("penpose_files_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string path(const char* name) const { return (folder_ / name).string(); }
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) found.push_back(entry.path().filename());
    return found;
  }

  std::filesystem::path folder_;
};

TEST_F(Files, WhatIsWrittenReadsBack) {
  const std::string text("a\0b\r\n\xff", 6);
  ASSERT_TRUE(write_file(path("x"), base::as_bytes(text)));
  const auto bytes = read_file(path("x")).value();
  EXPECT_EQ(base::as_text(bytes), text);
  ASSERT_TRUE(write_file(path("x"), {}));
  EXPECT_TRUE(read_file(path("x"))->empty());
  EXPECT_EQ(names(), (std::vector<std::string>{"x"})) << "nothing temporary stays";
}

TEST_F(Files, AFileLargerThanABufferIsReadWhole) {
  std::vector<std::uint8_t> bytes(300000);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i * 7 + i / 251);
  ASSERT_TRUE(write_file(path("large"), bytes));
  EXPECT_EQ(read_file(path("large")).value(), bytes);
}

TEST_F(Files, WhatCannotBeReadIsAnError) {
  EXPECT_NE(read_file(path("missing")).error().what.find("cannot be opened"), std::string::npos);
  EXPECT_EQ(read_file(folder_.string()).error().what, "is a folder");
  EXPECT_FALSE(read_file(""));
}

TEST_F(Files, WhatCannotBeWrittenLeavesTheOldContentAndNothingElse) {
  EXPECT_FALSE(write_file(path("no/such/folder"), {}));
  std::filesystem::create_directory(path("taken"));
  std::ofstream(folder_ / "taken" / "inside") << "x";
  const auto status = write_file(path("taken"), base::as_bytes("new"));
  ASSERT_FALSE(status);
  EXPECT_FALSE(status.error().remedy.empty());
  EXPECT_EQ(names(), (std::vector<std::string>{"taken"}));
}

TEST_F(Files, ALinkStaysOneAndItsFileIsWritten) {
  std::filesystem::create_directory(path("work"));
  std::ofstream(folder_ / "work" / "face.glb") << "old";
  std::filesystem::create_symlink("work/face.glb", path("face.glb"));
  std::filesystem::create_symlink("face.glb", path("again.glb"));
  ASSERT_TRUE(write_file(path("again.glb"), base::as_bytes("new")));
  EXPECT_TRUE(std::filesystem::is_symlink(path("again.glb")));
  EXPECT_TRUE(std::filesystem::is_symlink(path("face.glb")));
  EXPECT_EQ(base::as_text(read_file(path("work/face.glb")).value()), "new");
  // One whose file is not there yet makes it, and one that leads in a circle is an error.
  std::filesystem::create_symlink("work/later.glb", path("later.glb"));
  ASSERT_TRUE(write_file(path("later.glb"), base::as_bytes("first")));
  EXPECT_EQ(base::as_text(read_file(path("work/later.glb")).value()), "first");
  std::filesystem::create_symlink("circle", path("circle"));
  EXPECT_FALSE(write_file(path("circle"), {}));
}

TEST_F(Files, WhoMayReadAFileStaysAsItWas) {
  using std::filesystem::perms;
  for (const perms mode : {perms::owner_read | perms::owner_write, perms::owner_all | perms::group_read}) {
    ASSERT_TRUE(write_file(path("private"), base::as_bytes("a")));
    std::filesystem::permissions(path("private"), mode);
    ASSERT_TRUE(write_file(path("private"), base::as_bytes("b")));
    EXPECT_EQ(std::filesystem::status(path("private")).permissions(), mode);
  }
}

TEST_F(Files, APipeIsWrittenToAndStaysAPipe) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  std::string got;
  std::thread reader([&] { got = base::as_text(read_file(path("pipe")).value()); });
  EXPECT_TRUE(write_file(path("pipe"), base::as_bytes("a model")));
  reader.join();
  EXPECT_EQ(got, "a model");
  EXPECT_TRUE(std::filesystem::is_fifo(path("pipe")));
  EXPECT_TRUE(write_file("/dev/null", base::as_bytes("a model")));
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  EXPECT_FALSE(write_file("/dev/full", base::as_bytes("a model"))) << "as a full disk";
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST_F(Files, AReportIsOneLineThatNamesFilePlaceAndRemedy) {
  testing::internal::CaptureStderr();
  const int status = report({"is\nbroken", "line 3", "mend it"}, "a.obj");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "penpose: a.obj: line 3: is broken; mend it\n");
  EXPECT_EQ(status, k_failure);
}

}  // namespace
}  // namespace penpose::files
