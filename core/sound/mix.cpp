#include "core/sound/mix.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace penpose::sound {

std::int64_t sample_of(double time_s, int rate_hz) {
  // Far beyond any timeline; what is not a number is its beginning.
  constexpr double k_far = 1e15;
  const double at = std::floor(time_s * rate_hz + 0.5);
  return std::isnan(at) ? 0 : static_cast<std::int64_t>(std::clamp(at, -k_far, k_far));
}

void mix(const Sound& sound, double offset_s, std::int64_t first, std::span<float> out) {
  std::fill(out.begin(), out.end(), 0.0F);
  const std::int64_t begin = first - sample_of(offset_s, sound.rate_hz);
  const auto count = static_cast<std::int64_t>(sound.samples.size());
  const std::int64_t from = std::max<std::int64_t>(0, -begin);
  const std::int64_t to = std::min(static_cast<std::int64_t>(out.size()), count - begin);
  if (from >= to) return;
  std::copy(sound.samples.begin() + (begin + from), sound.samples.begin() + (begin + to), out.begin() + from);
}

void mix_slowed(const Sound& sound, double offset_s, std::int64_t first, double speed, std::span<float> out) {
  if (speed == 1) return mix(sound, offset_s, first, out);
  const double from = static_cast<double>(first) * speed;
  const double begin = std::floor(from);
  std::vector<float> played(static_cast<std::size_t>(std::ceil(speed * static_cast<double>(out.size()))) + 2);
  mix(sound, offset_s, static_cast<std::int64_t>(begin), played);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double at = from - begin + speed * static_cast<double>(i);
    const auto before = std::min(static_cast<std::size_t>(at), played.size() - 2);
    const auto part = static_cast<float>(at - static_cast<double>(before));
    out[i] = played[before] + part * (played[before + 1] - played[before]);
  }
}

void fade_ends(std::span<float> snippet, std::size_t fade) {
  const std::size_t over = std::min(fade, snippet.size() / 2);
  for (std::size_t i = 0; i < over; ++i) {
    const float part = static_cast<float>(i) / static_cast<float>(over);
    snippet[i] *= part;
    snippet[snippet.size() - 1 - i] *= part;
  }
}

}  // namespace penpose::sound
