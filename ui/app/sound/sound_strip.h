#pragma once

#include "core/document/sound/mouths.h"
#include "core/document/sound/spoken_words.h"
#include "ui/app/panels/panels.h"
#include "ui/app/sound/sound_track.h"

namespace penpose::app {

/// What is said in the sound.
struct SpokenSound {
  const document::SpokenWords* words = nullptr;    ///< seconds of the sound; null: they are not known
  const document::SpokenMouths* mouths = nullptr;  ///< shown where no words are known; null: none
};

/// The sound as a strip of the timeline that shows `span_s` seconds from `from_s` on: dragged sideways it begins at
/// another moment; a button at its end mutes it. What is said stands on it where there is room. Nothing where there is
/// no sound.
void show_sound_strip(PanelContext& context, SoundTrack& track, const SpokenSound& said, const Playback& playback,
                      double from_s, double span_s);

/// How high the strip is, px; 0 where there is no sound.
[[nodiscard]] double sound_strip_height(const PanelContext& context, const SoundTrack& track);

}  // namespace penpose::app
