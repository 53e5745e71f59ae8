#include "core/sound/resample.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "core/base/math.h"

namespace penpose::sound {
namespace {

constexpr double k_zeros = 24;
constexpr double k_cut_off = 0.94;

/// Blackman's window over -1..1.
double blackman(double x) {
  if (x <= -1 || x >= 1) return 0;
  return 0.42 + 0.5 * base::cos(base::k_pi * x) + 0.08 * base::cos(2 * base::k_pi * x);
}

double sinc(double x) {
  if (x == 0) return 1;
  return base::sin(base::k_pi * x) / (base::k_pi * x);
}

}  // namespace

Sound resampled(const Sound& sound, int rate_hz) {
  if (rate_hz == sound.rate_hz || sound.samples.empty()) return {rate_hz, sound.samples};
  // Sample i of the result lies at i * down / up samples of the sound.
  const int common = std::gcd(rate_hz, sound.rate_hz);
  const std::int64_t up = rate_hz / common;
  const std::int64_t down = sound.rate_hz / common;
  const double band = k_cut_off * std::min(1.0, static_cast<double>(up) / static_cast<double>(down));
  const auto half = static_cast<std::int64_t>(k_zeros / band) + 1;
  const auto taps = static_cast<std::size_t>(2 * half);
  // The filter for each place between two samples where a result may lie.
  std::vector<float> filters(static_cast<std::size_t>(up) * taps);
  std::vector<double> filter(taps);
  for (std::int64_t phase = 0; phase < up; ++phase) {
    const double between = static_cast<double>(phase) / static_cast<double>(up);
    double sum = 0;
    for (std::size_t t = 0; t < taps; ++t) {
      const double x = static_cast<double>(static_cast<std::int64_t>(t) - half + 1) - between;
      filter[t] = sinc(x * band) * blackman(x * band / k_zeros);
      sum += filter[t];
    }
    for (std::size_t t = 0; t < taps; ++t)
      filters[static_cast<std::size_t>(phase) * taps + t] = static_cast<float>(filter[t] / sum);
  }
  const auto count = static_cast<std::int64_t>(sound.samples.size());
  const std::int64_t out_count = std::min(static_cast<std::int64_t>(k_most_samples), (count * up + down - 1) / down);
  Sound out{rate_hz, std::vector<float>(static_cast<std::size_t>(out_count))};
  for (std::int64_t i = 0; i < out_count; ++i) {
    const std::int64_t whole = i * down / up;
    const float* weights = filters.data() + static_cast<std::size_t>(i * down % up) * taps;
    const std::int64_t first = whole - half + 1;
    double sum = 0;
    const std::int64_t end = std::min(static_cast<std::int64_t>(taps), count - first);
    for (std::int64_t t = std::max<std::int64_t>(0, -first); t < end; ++t)
      sum += static_cast<double>(weights[t]) * static_cast<double>(sound.samples[static_cast<std::size_t>(first + t)]);
    out.samples[static_cast<std::size_t>(i)] = static_cast<float>(std::clamp(sum, -1.0, 1.0));
  }
  return out;
}

}  // namespace penpose::sound
