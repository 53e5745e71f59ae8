#include "ui/files/process/standard_streams.h"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <iostream>
#include <unistd.h>

namespace penpose::files {

void hold_standard_streams() {
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream) {
    // The lowest free number is the one that is closed. Not for writing, so that what is written is missed.
    if (::fcntl(stream, F_GETFD) < 0 && errno == EBADF && ::open("/dev/null", O_RDONLY) < 0) return;
  }
}

base::Status finish_output() {
  std::cout.flush();
  const bool written = static_cast<bool>(std::cout) && std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (written) return base::Done{};
  return base::Error{"what was printed could not be written", "standard output",
                     "check what it leads to and the free space"};
}

}  // namespace penpose::files
