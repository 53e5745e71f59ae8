#pragma once

#include <cstdint>

namespace penpose::device {

/// Microseconds of a clock that never jumps and stops while the system sleeps (CLOCK_MONOTONIC).
[[nodiscard]] std::int64_t monotonic_us();

/// Microseconds that the system has slept since it was started: the sum of all suspends.
[[nodiscard]] std::int64_t slept_us();

}  // namespace penpose::device
