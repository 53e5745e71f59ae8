#pragma once

#include <vector>

#include "core/sound/sound.h"
#include "core/speech/cues.h"

namespace penpose::speech {

/// How loud a sound is where lips are heard: its differences' energy in steps of k_loudness_step_s, dB below full scale
/// (-100..0). Differences, since the hum of an m goes on while the lips are closed.
[[nodiscard]] std::vector<double> loudness_of(const sound::Sound& sound);
inline constexpr double k_loudness_step_s = 0.005;

/// The cues with each closed mouth from where the sound falls to where it rises again. Lips close and open at most
/// k_farthest_s from where they were thought to.
[[nodiscard]] Cues with_closures(const Cues& cues, const sound::Sound& sound);
inline constexpr double k_farthest_s = 0.04;

}  // namespace penpose::speech
