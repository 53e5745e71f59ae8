#include "ui/app/playback/frames.h"

#include <algorithm>
#include <cstdio>

#include "core/base/numbers.h"

namespace penpose::app {
namespace {

/// Shares of a frame that are none.
constexpr double k_same_frame = 1e-3;

bool is_whole(double frame) { return std::abs(frame - std::round(frame)) < k_same_frame; }

}  // namespace

std::string frame_text(double time_s, int rate) {
  const double frame = frame_of(time_s, rate);
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), is_whole(frame) ? "%.0f" : "%.1f", frame);
  return text.data();
}

std::optional<double> typed_moment(std::string_view text, int rate) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  const bool seconds = !text.empty() && text.back() == 's';
  if (seconds) text.remove_suffix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  const auto value = base::parse_double(text);
  if (!value || !std::isfinite(*value)) return std::nullopt;
  return seconds ? *value : time_of_frame(*value, rate);
}

std::optional<int> rate_of(std::span<const double> moments_s) {
  if (std::none_of(moments_s.begin(), moments_s.end(), [](double time) { return time > 0; })) return std::nullopt;
  for (const int rate : k_frame_rates) {
    if (std::all_of(moments_s.begin(), moments_s.end(), [&](double time) { return is_whole(frame_of(time, rate)); })) {
      return rate;
    }
  }
  return std::nullopt;
}

double step_frame(double time_s, int frames, int rate) {
  const double frame = frame_of(time_s, rate);
  if (is_whole(frame)) return (std::round(frame) + frames) / rate;
  return (frames > 0 ? std::floor(frame) + frames : std::ceil(frame) + frames) / rate;
}

}  // namespace penpose::app
