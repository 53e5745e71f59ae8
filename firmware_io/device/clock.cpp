#include "firmware_io/device/clock.h"

#include <ctime>

namespace penpose::device {
namespace {

std::int64_t read_clock(clockid_t clock) {
  timespec now{};
  ::clock_gettime(clock, &now);
  return static_cast<std::int64_t>(now.tv_sec) * 1'000'000 + now.tv_nsec / 1000;
}

}  // namespace

std::int64_t monotonic_us() { return read_clock(CLOCK_MONOTONIC); }

std::int64_t slept_us() { return read_clock(CLOCK_BOOTTIME) - read_clock(CLOCK_MONOTONIC); }

}  // namespace penpose::device
