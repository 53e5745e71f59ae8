#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "firmware_io/decode/sample/touch_slots.h"

namespace penpose::decode {

/// Suppresses fingers while the pen is near and for a moment after, because the drawing hand rests on the tablet. A
/// finger that is down during that time is a palm until it is lifted, however long it stays; so is one that was down
/// before the pen came near, from then on.
class PalmGuard {
 public:
  /// How long after the pen left a hand may still come down. About the time between two strokes that belong together.
  static constexpr std::int64_t k_default_hold_us = 500'000;

  explicit PalmGuard(std::int64_t hold_us = k_default_hold_us) : hold_us_(hold_us) {}

  /// Reports the pen's latest state. Times never decrease.
  void pen(bool near, std::int64_t time_us);
  /// The fingers of a frame without palms, in order. Valid until the next call.
  [[nodiscard]] std::span<const TouchContact> let_through(std::span<const TouchContact> contacts, std::int64_t time_us);
  [[nodiscard]] bool holds_back(std::int64_t time_us) const;
  void reset();

 private:
  std::int64_t hold_us_;
  bool near_ = false;
  bool seen_ = false;  ///< a pen has been near
  std::int64_t left_us_ = 0;
  std::vector<std::uint32_t> palms_;  ///< suppressed fingers that are down
  std::vector<TouchContact> through_;
};

}  // namespace penpose::decode
