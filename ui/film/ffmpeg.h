#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <sys/types.h>
#include <vector>

#include "core/base/interface.h"
#include "core/base/result.h"

namespace penpose::film {

/// Asked again and again during long work: whether to give it up.
using Stop = std::function<bool()>;

/// What is said of work that was given up.
[[nodiscard]] base::Error given_up();

/// Whether there is an ffmpeg on the PATH now.
[[nodiscard]] bool has_ffmpeg();

/// Why nothing can be written that needs it, and what to do.
[[nodiscard]] base::Error no_ffmpeg();

/// A file in memory that only programs with its descriptor see.
class MemoryFile : base::Fixed {
 public:
  MemoryFile();
  ~MemoryFile();
  [[nodiscard]] int descriptor() const { return file_; }
  [[nodiscard]] base::Status fill(std::span<const std::uint8_t> bytes) const;

 private:
  int file_ = -1;
};

/// ffmpeg at work, which reads what is written to it and ends with the object.
class Ffmpeg {
 public:
  /// `files` are its /proc/self/fd/3, 4, ... Errors: it is not there or does not start.
  static base::Result<Ffmpeg> start(const std::vector<std::string>& arguments, const std::vector<int>& files);
  Ffmpeg(Ffmpeg&& other) noexcept;
  Ffmpeg& operator=(Ffmpeg&&) = delete;
  ~Ffmpeg();

  /// Errors: given up; it has ended, with the last line that it said.
  [[nodiscard]] base::Status write(std::span<const std::uint8_t> bytes, const Stop& stop);
  /// There is no more to read; waits for its end. Errors: as above.
  [[nodiscard]] base::Status finish(const Stop& stop);

 private:
  Ffmpeg() = default;
  [[nodiscard]] base::Error failed() const;

  pid_t process_ = -1;
  int input_ = -1;
  int log_ = -1;
};

}  // namespace penpose::film
