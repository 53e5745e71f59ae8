#include "ui/files/process/rights.h"

#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <linux/landlock.h>
#include <string>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace penpose::files {
namespace {

class GivenUpRights : public testing::Test {
 protected:
  void SetUp() override {
    if (::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION) < 1)
      GTEST_SKIP() << "this kernel has no Landlock";
    std::ofstream(path_) << "as it was";
  }
  void TearDown() override { std::filesystem::remove(path_); }

  /// Runs `what` in a process that keeps only these rights; its result, or -1.
  template <typename What>
  int with(Rights rights, What what) const {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(keep_only(rights) ? what() : 99);
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  int reads() const { return ::open(path_.c_str(), O_RDONLY) >= 0 ? 1 : 0; }
  int writes() const { return ::open(path_.c_str(), O_WRONLY | O_TRUNC) >= 0 ? 1 : 0; }
  int makes() const { return ::open((path_ + "2").c_str(), O_WRONLY | O_CREAT, 0600) >= 0 ? 1 : 0; }
  static int starts() {
    ::execl("/bin/sh", "sh", "-c", "exit 1", nullptr);
    return 0;
  }

  std::string path_ =
      (std::filesystem::temp_directory_path() / ("penpose_rights_" + std::to_string(::getpid()))).string();
};

TEST_F(GivenUpRights, WhatOnlyReadsCanChangeNothingAndStartNothing) {
  EXPECT_EQ(with(Rights::reads_only, [&] { return reads(); }), 1);
  EXPECT_EQ(with(Rights::reads_only, [&] { return writes(); }), 0);
  EXPECT_EQ(with(Rights::reads_only, [&] { return makes(); }), 0);
  EXPECT_EQ(with(Rights::reads_only, [&] { return std::remove(path_.c_str()) == 0 ? 1 : 0; }), 0);
  EXPECT_EQ(with(Rights::reads_only, [] { return starts(); }), 0);
  std::ifstream file(path_);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), "as it was");
}

TEST_F(GivenUpRights, WhatWritesFilesStillDoesAndStartsNothing) {
  EXPECT_EQ(with(Rights::no_programs, [&] { return writes(); }), 1);
  EXPECT_EQ(with(Rights::no_programs, [] { return starts(); }), 0);
  EXPECT_EQ(with(Rights::all, [] { return starts(); }), 1);
}

}  // namespace
}  // namespace penpose::files
