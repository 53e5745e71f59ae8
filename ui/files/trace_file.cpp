#include "ui/files/trace_file.h"

#include <sys/stat.h>

#include "replay/recording/recording.h"

namespace penpose::files {

replay::ReadBytes read_from_file(std::FILE* file) {
  struct stat facts {};
  const bool plain = ::fstat(::fileno(file), &facts) == 0 && S_ISREG(facts.st_mode);
  const bool too_large = plain && static_cast<std::uint64_t>(facts.st_size) > k_most_trace_bytes;
  std::uint64_t left = plain ? k_most_trace_bytes : k_most_piped_bytes;
  return [file, plain, too_large, left](std::span<std::uint8_t> into) mutable -> base::Result<std::size_t> {
    const std::size_t got = too_large ? 0 : std::fread(into.data(), 1, into.size(), file);
    if (got == 0 && std::ferror(file) != 0) return base::Error{"cannot be read", "", "check the disk"};
    if (plain && (too_large || got > left)) {
      return base::Error{
          "is larger than " + std::to_string(k_most_trace_bytes >> 20) + " MiB, the most that is read of a trace", "",
          "cut it into pieces that begin with its lines of devices"};
    }
    if (got > left) {
      return base::Error{"is longer than " + std::to_string(k_most_piped_bytes >> 20) + " MiB, the most of a pipe", "",
                         "write it to a file and name that"};
    }
    left -= got;
    return got;
  };
}

replay::ReadBytes read_recording_file(std::FILE* file) { return replay::read_recording(read_from_file(file)); }

}  // namespace penpose::files
