#include "ui/cli/append_file.h"

#include "tests/support/command_run.h"

namespace penpose::cli {
namespace {

class AppendFileTest : public tests::CommandRun {};

TEST_F(AppendFileTest, HoldsEveryPieceAtOnce) {
  auto file = AppendFile::create(path("a.hid"), "one\n");
  ASSERT_TRUE(file);
  EXPECT_EQ(content("a.hid"), "one\n");
  ASSERT_TRUE(file->append("two\n"));
  EXPECT_EQ(content("a.hid"), "one\ntwo\n") << "before it is closed";
  EXPECT_TRUE(file->flush());
  EXPECT_EQ(files(), 1u);
}

TEST_F(AppendFileTest, ReplacesAnOlderFileWhole) {
  save("a.hid", std::string("an older recording"));
  auto file = AppendFile::create(path("a.hid"), "new\n");
  ASSERT_TRUE(file);
  EXPECT_EQ(content("a.hid"), "new\n");
}

TEST_F(AppendFileTest, AFolderThatIsNotThereIsAnError) {
  const auto file = AppendFile::create(path("none/a.hid"), "x");
  ASSERT_FALSE(file);
  EXPECT_NE(file.error().line().find("cannot be written (No such file or directory)"), std::string::npos);
}

TEST_F(AppendFileTest, WhatIsNoFileIsWrittenToAndNotReplaced) {
  EXPECT_TRUE(AppendFile::create("/dev/null", "x"));
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  EXPECT_FALSE(AppendFile::create("/dev/full", "x")) << "as a full disk";
}

}  // namespace
}  // namespace penpose::cli
