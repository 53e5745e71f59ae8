#pragma once

#include <csignal>

#include "core/base/interface.h"

namespace penpose::files {

/// While it lives, Ctrl-C and the other ways of asking a program to end only set a flag; afterwards they end it again.
class StopSignal : base::Fixed {
 public:
  StopSignal();
  ~StopSignal();

  [[nodiscard]] static bool asked();

 private:
  static constexpr int k_signals[] = {SIGINT, SIGTERM, SIGHUP};
  struct sigaction before_[3];
};

}  // namespace penpose::files
