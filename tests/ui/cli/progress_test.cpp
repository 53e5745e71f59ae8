#include "ui/cli/progress.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <iostream>
#include <stdlib.h>
#include <string>
#include <unistd.h>

namespace penpose::cli {
namespace {

TEST(Progress, IsSilentWhenPiped) {
  testing::internal::CaptureStderr();
  {
    Progress progress("posing", 3);
    for (int i = 0; i < 3; ++i) progress.advance();
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

/// Everything that standard error receives while it is a terminal; empty where none can be made.
std::string on_a_terminal(void (*work)()) {
  const int master = ::posix_openpt(O_RDWR | O_NOCTTY);
  if (master < 0 || ::grantpt(master) != 0 || ::unlockpt(master) != 0) return {};
  const int terminal = ::open(::ptsname(master), O_RDWR | O_NOCTTY);
  if (terminal < 0) return {};
  const int kept = ::dup(STDERR_FILENO);
  ::dup2(terminal, STDERR_FILENO);
  work();
  std::cerr.flush();
  ::dup2(kept, STDERR_FILENO);
  ::close(kept);
  // The kernel hands the text over in its own time; once the terminal is closed, reading ends after the last of it.
  ::close(terminal);
  std::string text;
  char piece[4096];
  for (ssize_t got = 0; (got = ::read(master, piece, sizeof piece)) > 0;)
    text.append(piece, static_cast<std::size_t>(got));
  ::close(master);
  return text;
}

TEST(Progress, ShowsEveryPercentOnATerminalAndTakesItsLineAway) {
  const std::string text = on_a_terminal([] {
    Progress progress("posing", 4);
    for (int i = 0; i < 4; ++i) progress.advance();
    progress.finish();
    progress.finish();
  });
  if (text.empty()) GTEST_SKIP() << "no terminal can be made here";
  EXPECT_EQ(text, "\rposing 25 %\rposing 50 %\rposing 75 %\rposing 100 %\r\033[K");
}

TEST(Progress, ManyStepsDoNotFloodTheTerminal) {
  const std::string text = on_a_terminal([] {
    Progress progress("x", 10000);
    for (int i = 0; i < 200; ++i) progress.advance();
  });
  if (text.empty()) GTEST_SKIP() << "no terminal can be made here";
  EXPECT_EQ(text, "\rx 0 %\rx 1 %\rx 2 %\r\033[K");
}

TEST(Progress, NothingToDoIsDone) {
  const std::string text = on_a_terminal([] {
    Progress progress("x", 0);
    progress.advance();
  });
  if (text.empty()) GTEST_SKIP() << "no terminal can be made here";
  EXPECT_EQ(text, "\rx 100 %\r\033[K");
}

}  // namespace
}  // namespace penpose::cli
