#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "firmware_io/decode/sample/touch_slots.h"

namespace penpose::decode {

/// Holds fingers back while the pen is near, and for a moment after: a hand that draws lies on the tablet. A finger
/// that was down during that time is a palm until it is lifted, however long it stays; so is one that was down before
/// the pen came, from then on.
class PalmGuard {
 public:
  /// How long after the pen a hand may still come down. About the time between two strokes that belong together.
  static constexpr std::int64_t k_default_hold_us = 500'000;

  explicit PalmGuard(std::int64_t hold_us = k_default_hold_us) : hold_us_(hold_us) {}

  /// What the pen said last. Times never go back.
  void pen(bool near, std::int64_t time_us);
  /// Those of the fingers of a frame that are none of a hand that draws, in their order. Valid until the next call.
  [[nodiscard]] std::span<const TouchContact> let_through(std::span<const TouchContact> contacts, std::int64_t time_us);
  [[nodiscard]] bool holds_back(std::int64_t time_us) const;
  void reset();

 private:
  std::int64_t hold_us_;
  bool near_ = false;
  bool seen_ = false;  ///< a pen was ever near
  std::int64_t left_us_ = 0;
  std::vector<std::uint32_t> palms_;  ///< fingers that are down and were held back
  std::vector<TouchContact> through_;
};

}  // namespace penpose::decode
