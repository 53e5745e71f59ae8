#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "firmware_io/decode/sample/pen_sample.h"

namespace penpose::decode {

/// The states of one report, without allocation. If there are too many, the newest overwrites the last.
class FrameList {
 public:
  static constexpr std::size_t k_most = 8;

  void clear() { count_ = 0; }
  void add(const PenSample& sample) {
    if (count_ < k_most) ++count_;
    samples_[count_ - 1] = sample;
  }
  [[nodiscard]] bool empty() const { return count_ == 0; }
  [[nodiscard]] std::span<const PenSample> all() const { return {samples_.data(), count_}; }

 private:
  std::array<PenSample, k_most> samples_;
  std::size_t count_ = 0;
};

}  // namespace penpose::decode
