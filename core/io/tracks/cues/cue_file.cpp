#include "core/io/tracks/cues/cue_file.h"

#include <array>

#include "core/base/text/letters.h"
#include "core/io/text/utf8_text.h"
#include "core/io/tracks/cues/internal/cue_reader.h"

namespace penpose::io {
namespace {

/// The forms, in the order in which they are tried.
const std::array<CueReader, 9>& cue_readers() {
  static const std::array<CueReader, 9> readers{rhubarb_reader(),  papagayo_reader(),  moho_reader(),
                                                textgrid_reader(), captions_reader(),  speech_marks_reader(),
                                                azure_reader(),    word_json_reader(), labels_reader()};
  return readers;
}

}  // namespace

const std::string& cue_format_names() {
  static const std::string names = [] {
    std::string all;
    for (const CueReader& reader : cue_readers()) all.append(all.empty() ? "" : ", ").append(reader.name);
    return all;
  }();
  return names;
}

bool looks_like_cues(std::string_view text) {
  text = base::without_mark(text);
  for (const CueReader& reader : cue_readers()) {
    if (reader.looks_like(text)) return true;
  }
  return false;
}

base::Result<CueFile> read_cues(base::Bytes bytes, base::Bytes dictionary) {
  const auto wide = text_of_utf16(bytes);
  if (!wide && is_binary(bytes)) {
    return base::Error{"the file is neither a sound that is read here nor a list of cues", "byte offset 0",
                       "give a sound (WAV, FLAC, OGG, MP3, AIFF), or cues of " + cue_format_names()};
  }
  std::string_view text = base::without_mark(wide ? std::string_view(*wide) : base::as_text(bytes));
  const auto other = text_of_latin1(text);
  if (other) text = *other;
  const CueReader* found = nullptr;
  for (const CueReader& reader : cue_readers()) {
    if (found == nullptr && reader.looks_like(text)) found = &reader;
  }
  const std::string unknown = "give cues of " + cue_format_names();
  CueBuilder cues(found != nullptr ? found->remedy : std::string_view(unknown));
  if (auto problem = found != nullptr ? found->read(text, cues) : read_timed_names(text, cues)) return *problem;
  return cues.finish(dictionary);
}

}  // namespace penpose::io
