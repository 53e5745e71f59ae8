#include "ui/cli/trace_file.h"

#include <limits>
#include <sys/stat.h>

namespace penpose::cli {

replay::ReadBytes read_from_file(std::FILE* file) {
  struct stat facts {};
  const bool ends = ::fstat(::fileno(file), &facts) == 0 && S_ISREG(facts.st_mode);
  std::uint64_t left = ends ? std::numeric_limits<std::uint64_t>::max() : k_most_piped_bytes;
  return [file, left](std::span<std::uint8_t> into) mutable -> base::Result<std::size_t> {
    const std::size_t got = std::fread(into.data(), 1, into.size(), file);
    if (got == 0 && std::ferror(file) != 0) return base::Error{"cannot be read", "", "check the disk"};
    if (got > left) {
      return base::Error{"is longer than " + std::to_string(k_most_piped_bytes >> 20) + " MiB, the most of a pipe", "",
                         "write it to a file and name that"};
    }
    left -= got;
    return got;
  };
}

}  // namespace penpose::cli
