#pragma once

#include <vector>

#include "core/sound/sound.h"

namespace penpose::sound {

/// The least and the greatest sample of a stretch.
struct Peak {
  float low = 0, high = 0;
  friend bool operator==(const Peak&, const Peak&) = default;
};

/// Peaks of a sound for drawing it, at several levels: a stretch of any length costs about the same.
class Peaks {
 public:
  Peaks() = default;
  explicit Peaks(const Sound& sound);

  /// The peak of the samples from `from_s` to `to_s`, at least of the one at `from_s`; stretches longer than
  /// k_bucket samples may take in neighbours up to an eighth of their length. Silent outside of the sound.
  /// Precondition: `sound` is the one that the peaks were made of.
  [[nodiscard]] Peak between(const Sound& sound, double from_s, double to_s) const;

  static constexpr std::size_t k_bucket = 64;  ///< samples of the finest level
  static constexpr std::size_t k_step = 4;     ///< buckets that make one of the next level

 private:
  std::vector<std::vector<Peak>> levels_;
};

}  // namespace penpose::sound
