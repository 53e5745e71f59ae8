#pragma once

#include <string>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "core/speech/phones.h"

namespace penpose::speech {

/// From a moment on, s, the mouth is that of a name, until the next one.
struct Cue {
  double time_s = 0;
  std::string mouth;
  friend bool operator==(const Cue&, const Cue&) = default;
};
/// Ascending in time.
using Cues = std::vector<Cue>;

/// The cues of a file of Rhubarb (TSV, XML or JSON) or Papagayo (.dat, at `moho_fps` frames a second), with names of
/// the nine mouths; a name that is in no table stays. Where the file tells its end, the last cue is rest, there.
/// Errors: as of io::read_cues.
[[nodiscard]] base::Result<Cues> read_mouth_cues(base::Bytes bytes, double moho_fps = 24);

/// The cues of phonemes. Pauses are rest; those below k_least_pause_s go with what follows them, or with closed lips
/// before them.
[[nodiscard]] Cues cues_of(const std::vector<Phone>& phones);
inline constexpr double k_least_pause_s = 0.25;

}  // namespace penpose::speech
