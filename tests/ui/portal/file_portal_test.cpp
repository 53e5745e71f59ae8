#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "ui/portal/portal.h"

// The portal on a bus of its own, with a service that answers by itself (mock_portal.py).

namespace penpose::portal {
namespace {

using Kind = FileAnswer::Kind;
using std::chrono::milliseconds;

/// A program whose output is read.
class Program {
 public:
  explicit Program(const std::vector<std::string>& command) {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) return;
    pid_ = ::fork();
    if (pid_ == 0) {
      ::dup2(ends[1], 1);
      ::close(ends[0]);
      ::close(ends[1]);
      std::vector<char*> words;
      for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
      words.push_back(nullptr);
      ::execvp(words[0], words.data());
      ::_exit(127);
    }
    ::close(ends[1]);
    output_ = ::fdopen(ends[0], "r");
  }
  ~Program() {
    if (pid_ > 0) {
      ::kill(pid_, SIGKILL);
      ::waitpid(pid_, nullptr, 0);
    }
    if (output_ != nullptr) std::fclose(output_);
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// The next line; empty at the end.
  std::string line() const {
    std::array<char, 4096> text{};
    if (output_ == nullptr || std::fgets(text.data(), text.size(), output_) == nullptr) return {};
    std::string read = text.data();
    if (read.ends_with('\n')) read.pop_back();
    return read;
  }

 private:
  pid_t pid_ = -1;
  FILE* output_ = nullptr;
};

class FilePortalTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!make_file_portal({})) GTEST_SKIP() << "built without the portal";
    bus_ = std::make_unique<Program>(
        std::vector<std::string>{"dbus-daemon", "--session", "--nofork", "--nopidfile", "--print-address=1"});
    const std::string address = bus_->line();
    if (address.empty()) GTEST_SKIP() << "there is no dbus-daemon";
    ::setenv("DBUS_SESSION_BUS_ADDRESS", address.c_str(), 1);
  }
  void TearDown() override { ::setenv("DBUS_SESSION_BUS_ADDRESS", "disabled:", 1); }

  /// Starts the service; false: its Python modules are missing.
  bool start(const char* how) {
    service_ = std::make_unique<Program>(std::vector<std::string>{"/usr/bin/python3", PENPOSE_MOCK_PORTAL, how});
    return service_->line() == "ready";
  }
  FileAnswer wait(FilePortal& portal) const {
    for (int i = 0; i < 1000; ++i) {
      FileAnswer answer = portal.take();
      if (answer.kind != Kind::waits) return answer;
      std::this_thread::sleep_for(milliseconds(10));
    }
    return {};
  }
  FileAnswer ask(const FileQuestion& question) {
    const auto portal = make_file_portal([this] { ++woken_; });
    const auto began = std::chrono::steady_clock::now();
    portal->ask(question);
    EXPECT_LT(std::chrono::steady_clock::now() - began, milliseconds(200)) << "nobody waits";
    FileAnswer answer = wait(*portal);
    EXPECT_EQ(portal->take().kind, Kind::waits) << "it is given once";
    return answer;
  }

  void expect_missed_within(milliseconds time) {
    const auto began = std::chrono::steady_clock::now();
    EXPECT_EQ(ask(question_).kind, Kind::unavailable);
    EXPECT_LT(std::chrono::steady_clock::now() - began, time);
  }

  FileQuestion question_{false, "Open", "x11:1a", "/tmp", {}, {{"Models", {".glb", ".obj"}}, {"Every file", {}}}};
  std::unique_ptr<Program> bus_;
  std::unique_ptr<Program> service_;
  std::atomic<int> woken_ = 0;
};

TEST_F(FilePortalTest, AFileIsChosenToOpen) {
  if (!start("open")) GTEST_SKIP();
  const FileAnswer answer = ask(question_);
  EXPECT_EQ(answer.kind, Kind::chosen);
  EXPECT_EQ(answer.path, "/tmp/a b.glb");
  EXPECT_EQ(service_->line(), "OpenFile|x11:1a|Open|/tmp|");
  EXPECT_EQ(service_->line(), "filter|Models|*.[gG][lL][bB] *.[oO][bB][jJ]");
  EXPECT_EQ(service_->line(), "filter|Every file|*");
  EXPECT_EQ(woken_, 1);
}

TEST_F(FilePortalTest, ANameIsOfferedToSaveUnder) {
  if (!start("save")) GTEST_SKIP();
  question_.saves = true;
  question_.name = "Gesicht \u00e4 100%.glb";
  const FileAnswer answer = ask(question_);
  EXPECT_EQ(answer.kind, Kind::chosen);
  EXPECT_EQ(answer.path, "/tmp/Gesicht \u00e4 100%.glb");
  EXPECT_EQ(service_->line(), "SaveFile|x11:1a|Open|/tmp|Gesicht \u00e4 100%.glb");
}

TEST_F(FilePortalTest, CancellingIsNoError) {
  if (!start("cancel")) GTEST_SKIP();
  EXPECT_EQ(ask(question_).kind, Kind::cancelled);
}

TEST_F(FilePortalTest, WhatRefusesOrEndsOtherwiseIsNone) {
  for (const char* how : {"error", "other", "odd"}) {
    if (!start(how)) GTEST_SKIP();
    EXPECT_EQ(ask(question_).kind, Kind::unavailable) << how;
    service_.reset();
    std::this_thread::sleep_for(milliseconds(100));
  }
}

TEST_F(FilePortalTest, OneThatDiesInTheMiddleIsMissed) {
  if (!start("dies")) GTEST_SKIP();
  expect_missed_within(milliseconds(1500));
}

TEST_F(FilePortalTest, ABusThatDiesInTheMiddleIsMissed) {
  if (!start("waits")) GTEST_SKIP();
  const auto portal = make_file_portal({});
  portal->ask(question_);
  EXPECT_NE(service_->line(), "");
  bus_.reset();
  EXPECT_EQ(wait(*portal).kind, Kind::unavailable);
}

TEST_F(FilePortalTest, OneThatSaysNothingIsMissedWithinAMoment) {
  if (!start("silent")) GTEST_SKIP();
  expect_missed_within(milliseconds(3500));
}

TEST_F(FilePortalTest, WithoutAServiceOrABusThereIsNoneAtOnce) {
  const auto began = std::chrono::steady_clock::now();
  EXPECT_EQ(ask(question_).kind, Kind::unavailable);
  ::setenv("DBUS_SESSION_BUS_ADDRESS", "unix:path=/nowhere/at/all", 1);
  EXPECT_EQ(ask(question_).kind, Kind::unavailable);
  EXPECT_LT(std::chrono::steady_clock::now() - began, milliseconds(1500));
}

TEST_F(FilePortalTest, WhoeverEndsClosesTheDialog) {
  if (!start("waits")) GTEST_SKIP();
  auto portal = make_file_portal([this] { ++woken_; });
  portal->ask(question_);
  for (int i = 0; i < 3; ++i) EXPECT_NE(service_->line(), "") << "it was asked";
  std::this_thread::sleep_for(milliseconds(300));
  EXPECT_EQ(portal->take().kind, Kind::waits);
  portal.reset();
  EXPECT_EQ(service_->line(), "closed");
  EXPECT_EQ(woken_, 0) << "nobody is there to be woken";
}

TEST(Address, OnlyFilesOfThisMachineArePaths) {
  EXPECT_EQ(path_of_address("file:///tmp/a%20b.glb"), "/tmp/a b.glb");
  EXPECT_EQ(path_of_address("file://localhost/a"), "/a");
  for (const char* none :
       {"http://x/a", "file://other/a", "file:///a%", "file:///a%2", "file:///a%zz", "file:///a%00b", "", "/tmp/a"})
    EXPECT_EQ(path_of_address(none), "") << none;
}

}  // namespace
}  // namespace penpose::portal
