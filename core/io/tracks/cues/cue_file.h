#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "core/phonetics/phones.h"

namespace penpose::io {

/// Mouth cues as a file has them, or as its phonemes or words are spoken.
struct CueFile {
  /// The mouth takes a shape at a time.
  struct Cue {
    double start_s = 0;
    std::string shape;  ///< as it is spelt in its table: "D" of Rhubarb's, "MBP" of Preston Blair's
    std::string place;  ///< in the file; empty for what its phonemes or words say
  };
  std::vector<Cue> list;                 ///< never empty; times do not step back
  double end_s = 0;                      ///< of the last; 0: not told
  double fps = 30;                       ///< of a track that is made of it
  bool counts_frames = false;            ///< the file has frames, of which `fps` were taken to make a second
  bool blair = false;                    ///< the shapes are Preston Blair's, or else Rhubarb's
  std::vector<speech::HeardWord> words;  ///< that the file names, ascending
  std::vector<std::string> notes;        ///< what was not taken as it stands
};

/// Which mouth is when, by what the file looks to be:
/// - cues of Rhubarb Lip Sync (tsv, XML, JSON) and Moho switches (.dat) of Papagayo and Rhubarb;
/// - Papagayo's projects (.pgo, .pg2);
/// - TextGrids of Praat, long or short, as the Montreal Forced Aligner writes them;
/// - speech marks of Amazon Polly, viseme events of Azure (units of 100 ns, milliseconds or seconds);
/// - labels of Audacity: phonemes, words or mouths; captions (SRT, WebVTT);
/// - JSON of words: WhisperX, Whisper, Gentle, Vosk and the like.
/// Text is UTF-8, UTF-16 with a byte order mark, or ISO 8859-1. Phonemes come before words where a file has both; words
/// are spoken by a dictionary (said_list; empty: by rules) over the time that they have. Errors: another form, binary
/// data, times that step back or lie beyond 1e6 s, no cue, more than 1,000,000 cues, 300,000 labels
/// or 150,000 sounds of words.
[[nodiscard]] base::Result<CueFile> read_cues(base::Bytes bytes, base::Bytes dictionary = {});

/// Returns true if a text matches one of these formats by more than a time and a name.
[[nodiscard]] bool looks_like_cues(std::string_view text);

/// Lists the formats that read_cues reads, for messages: "Rhubarb (tsv, xml, json), Papagayo (.pgo, .dat), ...".
[[nodiscard]] const std::string& cue_format_names();

}  // namespace penpose::io
