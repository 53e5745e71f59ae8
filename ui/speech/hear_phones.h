#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/phonetics/phones.h"
#include "core/sound/sound.h"

namespace penpose::speech {

/// How far listening has come, for other threads.
struct Listening {
  std::atomic<double> share = 0;      ///< 0..1
  std::atomic<bool> stopped = false;  ///< it is to end as soon as it can
};

/// The phonemes that are spoken in a sound and when, ascending, with pauses between them; what is said is English.
///
/// `text`: what is said, where it is known: then its words are looked up and laid along the sound, which is far more
/// certain than hearing alone. Empty: phonemes are recognised without words. `model`: the folder with PocketSphinx'
/// acoustic model "en-us", "en-us-phone.lm.bin" and "cmudict-en-us.dict"; empty: where Debian has it. `listening`:
/// null, or where it is told how far it is. Errors: a build without PocketSphinx (PENPOSE_SPEECH), no model there, a
/// text that the sound does not say, nothing that is spoken, a sound longer than k_longest_speech_s, stopped.
[[nodiscard]] base::Result<std::vector<Phone>> hear_phones(const sound::Sound& sound, const std::string& text,
                                                           const std::string& model = {},
                                                           Listening* listening = nullptr);
inline constexpr double k_longest_speech_s = 600;

/// Whether speech can be heard here. Errors: a build without PocketSphinx, no model in the folder (`model` as above).
[[nodiscard]] base::Status can_hear(const std::string& model = {});

}  // namespace penpose::speech
