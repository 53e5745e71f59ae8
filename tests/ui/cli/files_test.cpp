#include "ui/cli/files.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

#include "ui/cli/commands.h"

namespace penpose::cli {
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

TEST_F(Files, AReportIsOneLineThatNamesFilePlaceAndRemedy) {
  testing::internal::CaptureStderr();
  const int status = report({"is\nbroken", "line 3", "mend it"}, "a.obj");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "penpose: a.obj: line 3: is broken; mend it\n");
  EXPECT_EQ(status, k_failure);
}

}  // namespace
}  // namespace penpose::cli
