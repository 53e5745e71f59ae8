#pragma once

#include <cstddef>
#include <string>

namespace penpose::cli {

/// Progress of long work on standard error, when that is a terminal; silent otherwise.
class Progress {
 public:
  Progress(std::string what, std::size_t total);
  ~Progress() { finish(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void advance(std::size_t steps = 1);
  /// Takes the line away again.
  void finish();

 private:
  std::string what_;
  std::size_t total_;
  std::size_t done_ = 0;
  int shown_percent_ = -1;
  bool visible_;
};

}  // namespace penpose::cli
