#include "core/animation/track.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/animation/signal/statistics.h"

namespace penpose::animation {

double frames_per_second(double first_s, double last_s, std::size_t frames) {
  if (frames < 2 || !(last_s > first_s)) return 0;
  return static_cast<double>(frames - 1) / (last_s - first_s);
}

namespace {

/// How far the times are from whole frames, in frames; 2 where two of them would be one frame.
double off_frames(std::span<const double> times_s, double fps) {
  double most = 0;
  double last = -1;
  for (const double time : times_s) {
    const double frame = std::floor(time * fps + 0.5);
    if (!(frame > last)) return 2;
    last = frame;
    most = std::max(most, std::abs(time * fps - frame));
  }
  return most;
}

}  // namespace

double whole_frame_rate(std::span<const double> times_s, double within) {
  if (times_s.size() < 2 || times_s.front() < 0) return 0;
  std::vector<double> steps;
  for (std::size_t i = 1; i < times_s.size(); ++i) steps.push_back(times_s[i] - times_s[i - 1]);
  const double step = quantile(steps, 0.5);
  if (!(step > 0) || !std::isfinite(1 / step)) return 0;
  constexpr std::array<double, 13> k_rates{
      24, 25, 30, 50, 60, 15, 12.5, 10, 100, 120, 24000 / 1001.0, 30000 / 1001.0, 60000 / 1001.0};
  constexpr double k_near = 0.04;  // times in milliseconds leave steps of 33 and 34
  double best = 0;
  double least = within;
  for (const double rate : k_rates) {
    if (!(std::abs(step * rate - 1) < k_near)) continue;
    const double off = off_frames(times_s, rate);
    if (off > least || (best > 0 && off == least)) continue;
    best = rate;
    least = off;
  }
  if (best > 0) return best;
  return off_frames(times_s, 1 / step) <= within ? 1 / step : 0.0;
}

std::vector<double> at_whole_frames(std::span<const double> times_s, double fps) {
  std::vector<double> result;
  for (const double time : times_s) result.push_back(std::floor(time * fps + 0.5) / fps);
  return result;
}

}  // namespace penpose::animation
