#pragma once

#include <cstdint>
#include <functional>

#include "core/geometry/space.h"

namespace penpose::app {

using geometry::PxPoint;

/// Where the pointer is, and whether it is a tablet's pen that moves it.
class PointerPlace {
 public:
  /// Microseconds of a clock that never goes back.
  using Clock = std::function<std::int64_t()>;

  explicit PointerPlace(Clock clock) : clock_(std::move(clock)) {}

  [[nodiscard]] PxPoint at() const { return at_; }
  void move(PxPoint at) { at_ = at; }

  /// While a pen is near, the desktop's own pointer says nothing new.
  [[nodiscard]] bool tablet_is_near() const { return near_ && seen_us_ >= 0 && clock_() - seen_us_ < k_quiet_us; }
  /// A tablet has reported a pen, which stays near or goes.
  void tablet_reported(bool near) {
    seen_us_ = clock_();
    near_ = near;
  }
  void tablet_gone() { near_ = false; }

 private:
  /// After the last report of a pen that is near, the desktop's own pointer is ignored so long.
  static constexpr std::int64_t k_quiet_us = 250'000;

  Clock clock_;
  PxPoint at_;
  std::int64_t seen_us_ = -1;
  bool near_ = false;
};

}  // namespace penpose::app
