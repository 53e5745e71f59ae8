#pragma once

#include <algorithm>
#include <chrono>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>

namespace penpose::tests {

/// Spaces what a virtual device sends by the clock: what comes too late is followed at once by the next, so that the
/// rate holds on the average. What a machine that stood still has missed is left out but for the last `at_once`: no
/// device sends after the fact, and the kernel's queues are short.
/// The thread that makes it and waits is run after all others: no device takes the processor from who reads it.
class Pace {
 public:
  Pace(std::chrono::microseconds period, int at_once)
      : period_(period), most_behind_(period * at_once), next_(Clock::now()) {
    ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), k_last);
  }

  /// Returns when the next one is due.
  void wait() {
    std::this_thread::sleep_until(next_);
    next_ = std::max(next_, Clock::now() - most_behind_) + period_;
  }
  /// Nothing was due until now.
  void begin() { next_ = Clock::now(); }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr int k_last = 19;

  std::chrono::microseconds period_;
  std::chrono::microseconds most_behind_;
  Clock::time_point next_;
};

}  // namespace penpose::tests
