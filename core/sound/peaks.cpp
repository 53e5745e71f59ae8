#include "core/sound/peaks.h"

#include <algorithm>
#include <span>

namespace penpose::sound {
namespace {

Peak joined(const Peak& a, const Peak& b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }

Peak peak_of(std::span<const float> samples) {
  const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
  return {*low, *high};
}

/// The number of a sample at a moment, 0..count.
std::size_t sample_at(double time_s, int rate_hz, std::size_t count) {
  const double at = time_s * rate_hz;
  if (!(at > 0)) return 0;
  return at >= static_cast<double>(count) ? count : static_cast<std::size_t>(at);
}

}  // namespace

Peaks::Peaks(const Sound& sound) {
  const std::span<const float> all(sound.samples);
  std::vector<Peak> level;
  level.reserve(all.size() / k_bucket + 1);
  for (std::size_t i = 0; i < all.size(); i += k_bucket)
    level.push_back(peak_of(all.subspan(i, std::min(k_bucket, all.size() - i))));
  while (level.size() > k_step) {
    std::vector<Peak> next;
    next.reserve(level.size() / k_step + 1);
    for (std::size_t i = 0; i < level.size(); ++i) {
      if (i % k_step == 0) {
        next.push_back(level[i]);
      } else {
        next.back() = joined(next.back(), level[i]);
      }
    }
    levels_.push_back(std::move(level));
    level = std::move(next);
  }
  levels_.push_back(std::move(level));
}

Peak Peaks::between(const Sound& sound, double from_s, double to_s) const {
  const std::size_t count = sound.samples.size();
  if (!(to_s >= 0) || !(from_s < sound.duration_s())) return {};
  const std::size_t from = std::min(sample_at(from_s, sound.rate_hz, count), count - 1);
  const std::size_t to = std::max(sample_at(to_s, sound.rate_hz, count), from + 1);
  if (to - from <= 16 * k_bucket) return peak_of(std::span(sound.samples).subspan(from, to - from));
  // The coarsest level of which the stretch has 16 buckets: those at its ends are an eighth of it.
  std::size_t level = 0;
  std::size_t bucket = k_bucket;
  for (; level + 1 < levels_.size() && to - from > 16 * bucket * k_step; ++level) bucket *= k_step;
  const std::vector<Peak>& peaks = levels_[level];
  const std::size_t last = std::min((to - 1) / bucket, peaks.size() - 1);
  Peak out = peaks[from / bucket];
  for (std::size_t i = from / bucket + 1; i <= last; ++i) out = joined(out, peaks[i]);
  return out;
}

}  // namespace penpose::sound
