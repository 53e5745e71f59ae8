#pragma once

#include <csignal>

namespace penpose::files {

/// While it lives, Ctrl-C and the other ways of asking a program to end only set a flag; afterwards they end it again.
class StopSignal {
 public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

  [[nodiscard]] static bool asked();

 private:
  static constexpr int k_signals[] = {SIGINT, SIGTERM, SIGHUP};
  struct sigaction before_[3];
};

}  // namespace penpose::files
