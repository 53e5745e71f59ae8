#pragma once

#include <cstdint>
#include <vector>

#include "core/base/result.h"
#include "core/sound/sound.h"

namespace penpose::film {

/// A sound and the moment of the timeline at which it begins, s.
struct PlacedSound {
  sound::Sound sound;
  double offset_s = 0;
};

/// Of one film: an hour and a half at 48 kHz, 1 GB.
inline constexpr std::int64_t k_most_film_samples = std::int64_t{1} << 28;

/// What sounds during `frames` frames from the frame `first` on, of a sound that begins at a moment of the timeline:
/// exactly as long as they are shown, to the sample, and silent where there is no sound. Errors: more than
/// k_most_film_samples. Precondition: rate above 0.
[[nodiscard]] base::Result<sound::Sound> sound_of_frames(const sound::Sound& sound, double offset_s, int first,
                                                         std::size_t frames, double rate);

/// The bytes of a WAV file with samples of 32 bits, as floating point.
[[nodiscard]] std::vector<std::uint8_t> wav_bytes(const sound::Sound& sound);

}  // namespace penpose::film
