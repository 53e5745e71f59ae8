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

namespace {

/// Half the way from a rate to its thousandth less: 29.99 is 30, 29.97 is not.
constexpr double k_same = 0.0005;

/// The rate of times that are some whole numbers of steps apart, by their first and last; 0 for fewer than two.
double own_rate(std::span<const double> times_s, double step) {
  double frames = 0;
  for (std::size_t i = 1; i < times_s.size(); ++i) {
    frames += std::max(1.0, std::floor((times_s[i] - times_s[i - 1]) / step + 0.5));
  }
  const double passed = times_s.back() - times_s.front();
  return passed > 0 ? frames / passed : 0;
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
  // A clock that goes a little wrong: over a long clip its frames leave those of the rate that is meant.
  const double own = own_rate(times_s, step);
  if (own > 0 && off_frames(times_s, own) <= within) {
    for (const double rate : k_rates) {
      if (std::abs(own / rate - 1) < k_same && std::abs(own - rate) < std::abs(own - best)) best = rate;
    }
    if (best > 0) return best;
  }
  return off_frames(times_s, 1 / step) <= within ? 1 / step : 0.0;
}

std::vector<double> at_whole_frames(std::span<const double> times_s, double fps) {
  std::vector<double> result;
  std::vector<double> steps;
  for (std::size_t i = 1; i < times_s.size(); ++i) steps.push_back(times_s[i] - times_s[i - 1]);
  const double step = steps.empty() ? 0 : quantile(steps, 0.5);
  // Of a clock that goes a little wrong the frames are its own, of the rate that is meant.
  const double own = step > 0 && std::isfinite(1 / step) ? own_rate(times_s, step) : 0;
  const bool wrong =
      own > 0 && std::abs(own / fps - 1) < k_same && off_frames(times_s, fps) > 0.3 && off_frames(times_s, own) <= 0.3;
  for (const double time : times_s) result.push_back(std::floor(time * (wrong ? own : fps) + 0.5) / fps);
  return result;
}

}  // namespace penpose::animation
