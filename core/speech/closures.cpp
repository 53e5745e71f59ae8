#include "core/speech/closures.h"

#include <algorithm>
#include <cmath>

#include "core/base/math.h"
#include "core/phonetics/nine_mouths.h"

namespace penpose::speech {
namespace {

constexpr double k_window_s = 0.015;
constexpr double k_silent_db = -100;
/// Closed lips are heard no shorter.
constexpr double k_least_closed_s = 0.03;

/// The steps around a closure in which the sound is low: from the lowest one outwards while it is nearer to it than to
/// the loudest of both sides. Steps of the loudness; nothing where the sound does not fall.
struct Low {
  std::ptrdiff_t from = 0, to = 0;
  bool any = false;
};
Low low_around(const std::vector<double>& loudness, std::ptrdiff_t first, std::ptrdiff_t last) {
  constexpr double k_least_fall_db = 6;
  first = std::max<std::ptrdiff_t>(first, 0);
  last = std::min(last, static_cast<std::ptrdiff_t>(loudness.size()) - 1);
  if (first >= last) return {};
  const auto begin = loudness.begin() + first;
  const auto end = loudness.begin() + last + 1;
  const auto lowest = std::min_element(begin, end);
  const double before = *std::max_element(begin, lowest + 1);
  const double after = *std::max_element(lowest, end);
  Low low{lowest - loudness.begin(), lowest - loudness.begin(), false};
  low.any = std::max(before, after) - *lowest >= k_least_fall_db;
  while (low.from > first && loudness[static_cast<std::size_t>(low.from - 1)] < (*lowest + before) / 2) --low.from;
  while (low.to < last && loudness[static_cast<std::size_t>(low.to + 1)] < (*lowest + after) / 2) ++low.to;
  return low;
}

std::ptrdiff_t step_at(double time_s) { return static_cast<std::ptrdiff_t>(std::floor(time_s / k_loudness_step_s)); }

}  // namespace

std::vector<double> loudness_of(const sound::Sound& sound) {
  const auto count = static_cast<std::ptrdiff_t>(sound.samples.size());
  const auto window = static_cast<std::ptrdiff_t>(k_window_s * sound.rate_hz);
  std::vector<double> out;
  for (std::ptrdiff_t step = 0;; ++step) {
    const auto middle =
        static_cast<std::ptrdiff_t>((static_cast<double>(step) + 0.5) * k_loudness_step_s * sound.rate_hz);
    if (middle >= count) return out;
    double energy = 0;
    const std::ptrdiff_t from = std::max<std::ptrdiff_t>(1, middle - window / 2);
    const std::ptrdiff_t to = std::min(count, middle + window / 2 + 1);
    for (std::ptrdiff_t i = from; i < to; ++i) {
      const double difference = static_cast<double>(sound.samples[static_cast<std::size_t>(i)]) -
                                static_cast<double>(sound.samples[static_cast<std::size_t>(i - 1)]);
      energy += difference * difference;
    }
    const double mean = to > from ? energy / static_cast<double>(to - from) : 0;
    // 10 log10, by the natural logarithm.
    out.push_back(mean <= 1e-10 ? k_silent_db : std::min(0.0, 4.342944819032518 * base::log(mean)));
  }
}

Cues with_closures(const Cues& cues, const sound::Sound& sound) {
  const std::vector<double> loudness = loudness_of(sound);
  Cues out = cues;
  for (std::size_t i = 0; i < cues.size(); ++i) {
    if (cues[i].mouth != name_of(NineMouth::closed)) continue;
    const double from = cues[i].time_s;
    const double to = i + 1 < cues.size() ? cues[i + 1].time_s : sound.duration_s();
    const Low low = low_around(loudness, step_at(from - k_farthest_s), step_at(to + k_farthest_s));
    if (!low.any) continue;
    // Between neighbours stays some room for them.
    const double earliest = i > 0 ? std::max(from - k_farthest_s, (out[i - 1].time_s + from) / 2) : 0;
    const double latest =
        i + 2 < cues.size() ? std::min(to + k_farthest_s, (to + cues[i + 2].time_s) / 2) : to + k_farthest_s;
    const double closes = static_cast<double>(low.from) * k_loudness_step_s;
    const double opens = static_cast<double>(low.to + 1) * k_loudness_step_s;
    out[i].time_s = std::clamp(closes, earliest, std::max(earliest, std::min(from + k_farthest_s, to)));
    if (i + 1 < cues.size()) {
      const double least = std::max(out[i].time_s + k_least_closed_s, to - k_farthest_s);
      out[i + 1].time_s = std::clamp(opens, least, std::max(least, latest));
    }
  }
  for (std::size_t i = 1; i < out.size(); ++i) out[i].time_s = std::max(out[i].time_s, out[i - 1].time_s);
  return out;
}

}  // namespace penpose::speech
