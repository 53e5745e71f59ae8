#pragma once

#include <cstddef>
#include <vector>

namespace penpose::sound {

/// Rates that are taken, Hz.
inline constexpr int k_least_rate_hz = 4000, k_most_rate_hz = 384000;
/// The longest sound, samples: 23 minutes at 48 kHz, 256 MB.
inline constexpr std::size_t k_most_samples = std::size_t{1} << 26U;

/// A sound of one channel.
struct Sound {
  int rate_hz = 48000;         ///< k_least_rate_hz..k_most_rate_hz
  std::vector<float> samples;  ///< -1..1, finite
  [[nodiscard]] double duration_s() const { return static_cast<double>(samples.size()) / rate_hz; }
  friend bool operator==(const Sound&, const Sound&) = default;
};

}  // namespace penpose::sound
