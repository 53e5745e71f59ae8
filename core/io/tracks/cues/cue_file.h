#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/result.h"

namespace penpose::io {

/// Mouth cues as a file has them.
struct CueFile {
  /// The mouth takes a shape at a time.
  struct Cue {
    double start_s = 0;
    std::string shape;  ///< as it is spelt in its table: "D" of Rhubarb's, "MBP" of Preston Blair's
    std::string place;  ///< in the file
  };
  std::vector<Cue> list;       ///< never empty; times do not step back
  double end_s = 0;            ///< of the last; 0: not told
  double fps = 30;             ///< of a track that is made of it
  bool counts_frames = false;  ///< the file has frames, of which `fps` were taken to make a second
  bool blair = false;          ///< the shapes are Preston Blair's, or else Rhubarb's
};

/// Rhubarb Lip Sync's tsv, XML or JSON, or the Moho switches of Papagayo and Rhubarb (read_cue_track). Errors: another
/// form, times that step back or lie beyond 1e6 s, no cue, more than 1,000,000.
[[nodiscard]] base::Result<CueFile> read_cues(base::Bytes bytes);

/// Whether a text begins as XML does, and as a Moho switch does.
[[nodiscard]] bool is_xml_cues(std::string_view text);
[[nodiscard]] bool is_moho_switch(std::string_view text);
/// Whether a name is one of Rhubarb's letters.
[[nodiscard]] bool is_rhubarb_shape(std::string_view name);

}  // namespace penpose::io
