#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace penpose::app {

// The timeline counts seconds; an animator counts frames. What is shown and snapped to are frames of a rate.

/// The rates that can be chosen, frames a second.
inline constexpr std::array k_frame_rates{24, 25, 30, 48, 60};
inline constexpr int k_usual_rate = 24;

/// The frame at a moment, or what of one there is between two.
[[nodiscard]] inline double frame_of(double time_s, int rate) { return time_s * rate; }
[[nodiscard]] inline double time_of_frame(double frame, int rate) { return frame / rate; }
/// The moment of the nearest frame.
[[nodiscard]] inline double on_frame(double time_s, int rate) { return std::round(time_s * rate) / rate; }

/// "36", or "36.5" where the moment lies on no frame.
[[nodiscard]] std::string frame_text(double time_s, int rate);
/// The moment of what was typed: a frame ("36"), or seconds ("1.5s", "1.5 s"). Nothing: it is neither.
[[nodiscard]] std::optional<double> typed_moment(std::string_view text, int rate);

/// The rate on whose frames all moments lie: the first of `k_frame_rates`; nothing where there is none, and where no
/// moment but zero says anything.
[[nodiscard]] std::optional<int> rate_of(std::span<const double> moments_s);

/// The moment a frame before or after this one; from between two frames it is the neighbouring one.
[[nodiscard]] double step_frame(double time_s, int frames, int rate);

}  // namespace penpose::app
