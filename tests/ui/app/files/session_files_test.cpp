#include "ui/app/files/session_files.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

#include "replay/trace/trace_reader.h"

namespace penpose::app {
namespace {

class SessionFiles : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::remove_all(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string folder_ =
      (std::filesystem::temp_directory_path() / ("penpose-session-files-" + std::to_string(::getpid()))).string();
};

TEST_F(SessionFiles, ASessionThatIsThereIsNeverWrittenOver) {
  const auto first = SessionFile::create_in(folder_, "today", "test");
  const auto second = SessionFile::create_in(folder_, "today", "test");
  ASSERT_TRUE(first.ok() && second.ok());
  EXPECT_NE((*first)->path(), (*second)->path());
  EXPECT_FALSE(SessionFile::create((*first)->path(), "test").ok());
}

TEST_F(SessionFiles, ASessionOfARunningProgramIsNotAbandoned) {
  const auto running = SessionFile::create_in(folder_, "running", "test");
  ASSERT_TRUE(running.ok());
  EXPECT_TRUE(abandoned_sessions(folder_).empty());
  EXPECT_TRUE(std::filesystem::exists((*running)->path()));
}

TEST_F(SessionFiles, OneThatWasNeverFinishedIsAndOnlyIfSomethingWasDoneInIt) {
  for (const bool worked : {true, false}) {
    auto file = SessionFile::create_in(folder_, worked ? "worked" : "idle", "test");
    ASSERT_TRUE(file.ok());
    if (worked) {
      ASSERT_TRUE((*file)->writer().begin({}, "builtin:head").ok());
      ASSERT_TRUE((*file)->writer().state({}).ok());
    }
    // The lock goes with the program; `finish` is not called.
  }
  const auto found = abandoned_sessions(folder_);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found.front().find("worked"), std::string::npos);
  EXPECT_EQ(past_sessions(folder_).size(), 1U) << "the idle one is tidied away";
  settle_session(found.front());
  EXPECT_TRUE(abandoned_sessions(folder_).empty());
  EXPECT_EQ(past_sessions(folder_).size(), 1U) << "a settled session stays in the list";
}

TEST_F(SessionFiles, OneThatCannotBeReadToItsEndIsKept) {
  std::string path;
  {
    const auto file = SessionFile::create_in(folder_, "damaged", "test");
    ASSERT_TRUE(file.ok());
    ASSERT_TRUE((*file)->writer().begin({}, "builtin:head").ok());
    path = (*file)->path();
  }
  // A crash of the machine leaves zeros where something was; there is no state in what can be read.
  std::filesystem::resize_file(path, 2 * replay::TraceReader::k_most_of_a_line);
  EXPECT_TRUE(abandoned_sessions(folder_).empty());
  EXPECT_TRUE(std::filesystem::exists(path)) << "what was not read may hold work";
}

TEST_F(SessionFiles, APipeInPlaceOfANoteHoldsNothingUp) {
  std::filesystem::create_directories(folder_);
  const std::string path = folder_ + "/odd.session";
  std::ofstream(path) << "# penpose session edition=11 program=test\n# penpose state 00\n";
  ASSERT_EQ(::mkfifo((path + ".open").c_str(), 0600), 0);
  EXPECT_EQ(abandoned_sessions(folder_).size(), 1U);
  EXPECT_EQ(project_of_session(path), "");
}

TEST_F(SessionFiles, AFinishedSessionStaysAndOneWithoutWorkGoes) {
  for (const bool keep : {true, false}) {
    auto file = SessionFile::create_in(folder_, keep ? "kept" : "empty", "test");
    ASSERT_TRUE(file.ok());
    (*file)->finish(keep);
  }
  const auto left = past_sessions(folder_);
  ASSERT_EQ(left.size(), 1U);
  EXPECT_NE(left.front().find("kept"), std::string::npos);
}

}  // namespace
}  // namespace penpose::app
