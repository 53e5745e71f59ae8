#include "ui/files/fresh_file.h"

#include <csignal>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include "tests/support/command_run.h"
#include "ui/files/append_file.h"
#include "ui/files/files.h"

namespace penpose::files {
namespace {

class FreshFileTest : public tests::CommandRun {
 protected:
  void tidy() const {
    const int folder = ::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    remove_leftovers(folder);
    ::close(folder);
  }
};

TEST_F(FreshFileTest, WhatIsNotPlacedIsNowhere) {
  {
    const FreshFile file(path("a"), 0666);
    ASSERT_GE(file.descriptor(), 0);
    EXPECT_EQ(::write(file.descriptor(), "x", 1), 1);
  }
  EXPECT_EQ(files(), 0U);
  FreshFile file(path("a"), 0666);
  EXPECT_EQ(::write(file.descriptor(), "y", 1), 1);
  EXPECT_TRUE(file.place());
  EXPECT_EQ(content("a"), "y");
  EXPECT_EQ(files(), 1U);
}

TEST_F(FreshFileTest, TheLongestNameCanBeWrittenTwice) {
  const std::string name(255, 'n');
  ASSERT_TRUE(write_file(path(name), base::as_bytes("one")));
  ASSERT_TRUE(write_file(path(name), base::as_bytes("two")));
  EXPECT_EQ(content(name), "two");
  EXPECT_EQ(files(), 1U);
  EXPECT_FALSE(write_file(path(name + "n"), base::as_bytes("x")));
}

// Names of temporary files that can be told beforehand could be links to somebody else's files.
TEST_F(FreshFileTest, LinksThatArePlantedAreNotWrittenThrough) {
  save("victim", std::string("untouched"));
  for (const std::string& guess : {".part-" + std::to_string(::getpid()), std::string(".new"), std::string(".part")}) {
    std::filesystem::create_symlink("victim", path("out.glb" + guess));
  }
  ASSERT_TRUE(write_file(path("out.glb"), base::as_bytes("model")));
  ASSERT_TRUE(AppendFile::create(path("trace.hid"), "first\n"));
  EXPECT_EQ(content("victim"), "untouched");
  EXPECT_EQ(content("out.glb"), "model");
  // Nor is one that has the name of the file itself and is another user's, where this user can make such a link.
  if (::geteuid() != 0) return;
  std::filesystem::create_symlink("victim", path("planted.glb"));
  ASSERT_EQ(::lchown(path("planted.glb").c_str(), 12345, 12345), 0);
  EXPECT_EQ(write_file(path("planted.glb"), base::as_bytes("model")).error().what, "is a link of another user");
  EXPECT_EQ(content("victim"), "untouched");
}

TEST_F(FreshFileTest, WhatAKilledProgramLeftGoesAndNothingElse) {
  save(".penpose-0123456789abcdef.part", std::string("left"));
  save(".penpose-0123456789abcde.part", std::string("another name"));
  save("penpose-0123456789abcdef.part", std::string("another name"));
  std::filesystem::create_directory(path(".penpose-1111111111111111.part"));
  std::filesystem::create_symlink("penpose-0123456789abcdef.part", path(".penpose-2222222222222222.part"));
  save(".penpose-3333333333333333.part", std::string("being written"));
  const int held = ::open(path(".penpose-3333333333333333.part").c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_EQ(::flock(held, LOCK_EX), 0);
  tidy();
  EXPECT_EQ(files(), 5U);
  EXPECT_FALSE(std::filesystem::exists(path(".penpose-0123456789abcdef.part")));
  EXPECT_TRUE(std::filesystem::exists(path(".penpose-3333333333333333.part"))) << "somebody still writes it";
  ::close(held);
  tidy();
  EXPECT_FALSE(std::filesystem::exists(path(".penpose-3333333333333333.part")));
}

// Killed at any moment, a program leaves the file as it was or as it should be, and no heap of leftovers.
TEST_F(FreshFileTest, KillingTheProgramLeavesTheOldFileOrTheNewOne) {
  const std::string old(200000, 'o');
  const std::string fresh(200000, 'f');
  ASSERT_TRUE(write_file(path("model"), base::as_bytes(old)));
  int replaced = 0;
  for (int round = 0; round < 60; ++round) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      for (int i = 0;; ++i) static_cast<void>(write_file(path("model"), base::as_bytes(i % 2 == 0 ? fresh : old)));
    }
    ::usleep(static_cast<useconds_t>(500 + round * 97));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    const std::string now = content("model");
    ASSERT_TRUE(now == old || now == fresh) << now.size() << " bytes in round " << round;
    replaced += now == fresh ? 1 : 0;
  }
  EXPECT_GT(replaced, 0) << "it was killed before it had written anything";
  tidy();
  EXPECT_EQ(files(), 1U);
}

}  // namespace
}  // namespace penpose::files
