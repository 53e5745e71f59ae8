#pragma once

#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "core/sound/sound.h"

namespace penpose::sound {

/// Whether bytes begin like a sound that read_sound knows: WAV, FLAC or OGG.
[[nodiscard]] bool looks_like_sound(base::Bytes bytes);

/// Reads a WAV, FLAC or OGG file; channels are joined to their mean. Samples that are no numbers are silent, louder
/// ones than 1 are clipped. Errors: another file, a broken one, no samples, more than 32 channels, a rate out of
/// k_least_rate_hz..k_most_rate_hz, more than k_most_samples, a build without libsndfile (PENPOSE_SOUND).
[[nodiscard]] base::Result<Sound> read_sound(base::Bytes bytes);

/// Whether this build reads sounds.
[[nodiscard]] bool reads_sounds();

}  // namespace penpose::sound
