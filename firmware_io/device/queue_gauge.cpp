#include "firmware_io/device/queue_gauge.h"

namespace penpose::device {
namespace {

/// A tablet sends 20 reports at most in this time, so that most of those that were read in it were waiting.
constexpr std::int64_t k_burst_us = 20'000;

}  // namespace

bool QueueGauge::was_full(bool at_once, std::int64_t time_us) {
  // One that was waited for may be the first of a full queue: whoever waited was not run in time.
  if (!at_once || run_ == 0) {
    run_ = 1;
    begin_us_ = time_us;
    return false;
  }
  if (++run_ != k_capacity) return false;
  run_ = 0;
  return time_us - begin_us_ < k_burst_us;
}

}  // namespace penpose::device
