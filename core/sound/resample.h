#pragma once

#include "core/sound/sound.h"

namespace penpose::sound {

/// The sound at another rate, k_least_rate_hz..k_most_rate_hz: interpolated by a sinc under Blackman's window, 24 of
/// its zeros to each side, cut off at 0.94 of the lower of both rates' halves.
[[nodiscard]] Sound resampled(const Sound& sound, int rate_hz);

}  // namespace penpose::sound
