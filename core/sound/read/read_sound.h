#pragma once

#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "core/sound/sound.h"

namespace penpose::sound {

/// Returns true if bytes begin like a sound (sound_container), even one that read_sound refuses by name.
[[nodiscard]] bool looks_like_sound(base::Bytes bytes);

/// Reads a WAV (also RF64 and W64), FLAC, OGG (also Opus), MP3, AIFF, CAF or AU file, whatever its name; a tag of ID3
/// in front, and a WAV whose data has no size, as those have that were written into a pipe, are read too. Channels are
/// joined to their mean. Samples that are no numbers are silent, louder ones than 1 are clipped. Errors: another file
/// (MP4, AAC, WMA, AMR and WebM by name), a broken one, no samples, more than 32 channels, a rate out of
/// k_least_rate_hz..k_most_rate_hz, more than k_most_samples, a build without libsndfile (PENPOSE_SOUND).
[[nodiscard]] base::Result<Sound> read_sound(base::Bytes bytes);

/// Whether this build reads sounds.
[[nodiscard]] bool reads_sounds();

}  // namespace penpose::sound
