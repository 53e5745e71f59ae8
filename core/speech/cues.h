#pragma once

#include <string>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "core/document/commands/list/sound_commands.h"
#include "core/phonetics/cues.h"

namespace penpose::speech {

/// Holds one entry of a file about a mouth.
struct MouthCues {
  Cues cues;                       ///< never empty
  std::vector<HeardWord> words;    ///< that it names, ascending
  std::vector<std::string> notes;  ///< what was not taken as it stands
};

/// The cues of any file that io::read_cues reads, with names of the nine mouths; a name that is in no table stays.
/// Switches of Moho are at `moho_fps` frames a second. `dictionary`: how words are said. Where the file tells its end,
/// the last cue is rest, there. Errors: as of io::read_cues.
[[nodiscard]] base::Result<MouthCues> read_mouth_cues(base::Bytes bytes, double moho_fps = 24,
                                                      base::Bytes dictionary = {});

/// The command that keeps words with the sound; those that are empty, too long or before the one above them are left
/// out.
[[nodiscard]] document::SetWords words_kept(const std::vector<HeardWord>& words);

}  // namespace penpose::speech
