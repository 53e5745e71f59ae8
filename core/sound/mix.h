#pragma once

#include <cstdint>
#include <span>

#include "core/sound/sound.h"

namespace penpose::sound {

/// The samples of a sound that begins at `offset_s` of the timeline, from the sample `first` on, which is counted from
/// the timeline's beginning at the sound's rate. Silence where there is no sound.
void mix(const Sound& sound, double offset_s, std::int64_t first, std::span<float> out);

/// The same slowed down: sample n of the output sounds when the timeline is at n * speed. `first` counts samples of the
/// output. In between it is straight, so that the sound is lower as it is slower. Precondition: 0 < speed <= 1.
void mix_slowed(const Sound& sound, double offset_s, std::int64_t first, double speed, std::span<float> out);

/// The number of the sample that sounds at a moment of the timeline, s.
[[nodiscard]] std::int64_t sample_of(double time_s, int rate_hz);

/// Fades both ends of a snippet over `fade` samples, or half of it where it is shorter, so that it does not click.
void fade_ends(std::span<float> snippet, std::size_t fade);

}  // namespace penpose::sound
