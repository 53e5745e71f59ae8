#pragma once

#include "core/document/sound/mouths.h"
#include "core/speech/cues.h"

namespace penpose::speech {

struct KeyOptions {
  double fps = 24;       ///< keys lie on frames, 1..1000 a second
  double offset_s = 0;   ///< the moment of the timeline at which the sound begins
  double lead_s = 0.04;  ///< mouths come so much before their sound, and up to a frame more
};

/// Which mouth to key on which frame (document::KeyMouths), ascending. Closed lips and F come on the frame on which
/// their sound begins and stay for a frame at least; the others come by `lead_s` earlier, and are left out where lips
/// that have to meet take their frame. A mouth stays until k_change_frames before the next one.
[[nodiscard]] document::SpokenMouths mouth_keys(const Cues& cues, const KeyOptions& options);
inline constexpr int k_change_frames = 3;

}  // namespace penpose::speech
