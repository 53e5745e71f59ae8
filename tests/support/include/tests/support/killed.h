#pragma once

#include <csignal>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace penpose::tests {

/// Lets a child of this process work, which writes a byte into the pipe for all that it has done, and kills it after so
/// long. `told`: how many bytes there were. Fails where it ended by itself.
template <typename Work>
void told_until_killed(useconds_t after_us, const Work& work, std::size_t& told) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    ::close(ends[0]);
    work(ends[1]);
    ::_exit(1);
  }
  ::close(ends[1]);
  ::usleep(after_us);
  ::kill(child, SIGKILL);
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status)) << "it died by itself";
  told = 0;
  for (char byte = 0; ::read(ends[0], &byte, 1) == 1;) ++told;
  ::close(ends[0]);
}

}  // namespace penpose::tests
