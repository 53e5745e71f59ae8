#pragma once

#include <string>
#include <vector>

#include "core/phonetics/phones.h"

namespace penpose::speech {

/// From a moment on, s, the mouth is that of a name, until the next one.
struct Cue {
  double time_s = 0;
  std::string mouth;
  friend bool operator==(const Cue&, const Cue&) = default;
};
/// Ascending in time.
using Cues = std::vector<Cue>;

/// Adds a cue that is not before the last one: of two at a moment the later one counts, and one that changes nothing is
/// none.
void add_cue(Cues& cues, double time_s, std::string mouth);

/// The cues of phonemes. Pauses are rest; those below k_least_pause_s go with what follows them, or with closed lips
/// before them.
[[nodiscard]] Cues cues_of(const std::vector<Phone>& phones);
inline constexpr double k_least_pause_s = 0.25;

}  // namespace penpose::speech
